/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   The names of Butano that a game of tuff meets; the headers beside this one lead here. */
#ifndef BN_CORE_H
#define BN_CORE_H

#include <stdint.h>
#include <stddef.h>

#define BN_CODE_IWRAM __attribute__((section(".iwram")))
#define BN_DATA_EWRAM __attribute__((section(".ewram")))

namespace bn
{
    class fixed
    {
    public:
        constexpr fixed(int value) : _data(value * 4096) {}
        constexpr fixed(double value) : _data(int(value * 4096)) {}
        static constexpr fixed from_data(int data) { return fixed(data, 0); }
        constexpr int data() const { return _data; }
        friend constexpr fixed operator-(fixed a, fixed b) { return from_data(a._data - b._data); }
    private:
        constexpr fixed(int data, int) : _data(data) {}
        int _data;
    };

    namespace core
    {
        void init();
        void update();
    }

    namespace keypad
    {
        bool left_held();
        bool right_held();
        bool up_held();
        bool down_held();
    }

    class sprite_ptr
    {
    public:
        void set_position(fixed x, fixed y);
    };

    class sprite_item
    {
    public:
        sprite_ptr create_sprite(fixed x, fixed y) const;
    };

    namespace sprite_items
    {
        extern const sprite_item ship;
    }
}

#endif
