/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   Game Boy Advance with Butano: positions as bn::fixed, Q20.12, with the origin in the middle of the screen. */
#include "bn_core.h"
#include "bn_fixed.h"
#include "bn_keypad.h"
#include "bn_sprite_ptr.h"
#include "bn_sprite_items_ship.h"
#include "belt.h"

int main()
{
    bn::core::init();
    bn::sprite_ptr sprite = bn::sprite_items::ship.create_sprite(0, 0);
    const tuff_real thrust = tuff_from_q20_12(bn::fixed(0.0625).data());
    while (true) {
        fly((bn::keypad::right_held() - bn::keypad::left_held()) * thrust, (bn::keypad::down_held() - bn::keypad::up_held()) * thrust);
        sprite.set_position(bn::fixed::from_data(tuff_to_q20_12(ship.position.x)) - 120,
                            bn::fixed::from_data(tuff_to_q20_12(ship.position.y)) - 80);
        bn::core::update();
    }
}
