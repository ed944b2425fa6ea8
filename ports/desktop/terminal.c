/* SPDX-License-Identifier: Zlib
   Copyright (c) 2026 the tuff authors

   POSIX termios and a few escape sequences. The signal handlers call only what POSIX lists as safe in a handler. */
#include "terminal.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

/* The alternate screen without a cursor, and back. */
static const char enter[] = "\033[?1049h\033[?25l\033[0m\033[2J";
static const char leave[] = "\033[?2026l\033[0m\033[?25h\033[?1049l";

static struct termios saved, raw;
static volatile sig_atomic_t taken, has_keys, resumed;

bool terminal_present(void)
{
    return isatty(STDOUT_FILENO);
}

/* Safe in a handler; a write that fails has nobody left to tell. */
static void say(const char *text, size_t count)
{
    ssize_t written = write(STDOUT_FILENO, text, count);
    (void)written;
}

static void take(void)
{
    if (has_keys) tcsetattr(STDIN_FILENO, TCSANOW, &raw);
    say(enter, sizeof enter - 1);
    taken = 1;
}

static void give_back(void)
{
    if (!taken) return;
    taken = 0;
    say(leave, sizeof leave - 1);
    if (has_keys) tcsetattr(STDIN_FILENO, TCSANOW, &saved);
}

/* The handler is gone by now (SA_RESETHAND), so the signal does what it always does. */
static void on_end(int number)
{
    give_back();
    raise(number);
}

static void on_stop(int number)
{
    int before = errno;
    (void)number;
    give_back();
    raise(SIGSTOP);
    take();
    resumed = 1;
    errno = before;
}

static void handle(int number, void (*handler)(int), int flags)
{
    struct sigaction action;
    memset(&action, 0, sizeof action);
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, NULL);
}

bool terminal_open(void)
{
    static const int ends[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    has_keys = isatty(STDIN_FILENO) && tcgetattr(STDIN_FILENO, &saved) == 0;
    if (has_keys) {
        raw = saved;
        raw.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
        raw.c_cc[VMIN] = 0;
        raw.c_cc[VTIME] = 0;
    }
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) handle(ends[i], on_end, (int)SA_RESETHAND);
    handle(SIGTSTP, on_stop, SA_RESTART);
    take();
    return has_keys != 0;
}

void terminal_close(void)
{
    give_back();
}

void terminal_size(unsigned *columns, unsigned *rows)
{
    struct winsize size;
    *columns = 80;
    *rows = 24;
    if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0 || size.ws_row == 0) return;
    *columns = size.ws_col;
    *rows = size.ws_row;
}

/* One byte, or -1: none waits. */
static int next_byte(void)
{
    unsigned char byte;
    return has_keys && read(STDIN_FILENO, &byte, 1) == 1 ? byte : -1;
}

/* What follows an escape byte: ESC [ A or ESC O A for the arrows; everything else is skipped to its last letter. */
static int escape_sequence(void)
{
    int byte = next_byte();
    if (byte != '[' && byte != 'O') return KEY_NONE;
    do byte = next_byte();
    while (byte == ';' || (byte >= '0' && byte <= '9'));
    return byte >= 'A' && byte <= 'D' ? (int[]){KEY_UP, KEY_DOWN, KEY_RIGHT, KEY_LEFT}[byte - 'A'] : KEY_NONE;
}

int terminal_key(void)
{
    for (;;) {
        int byte = next_byte();
        if (byte < 0) return KEY_NONE;
        int key = byte == '\033' ? escape_sequence() : byte;
        if (key != KEY_NONE) return key;
    }
}

bool terminal_write(const char *bytes, size_t count)
{
    while (count != 0) {
        ssize_t written = write(STDOUT_FILENO, bytes, count);
        if (written < 0 && errno == EAGAIN) {
            struct pollfd wait = {STDOUT_FILENO, POLLOUT, 0};
            poll(&wait, 1, 100);
        } else if (written < 0 && errno != EINTR) {
            return false;
        } else if (written > 0) {
            bytes += written;
            count -= (size_t)written;
        }
    }
    return true;
}

bool terminal_resumed(void)
{
    bool yes = resumed != 0;
    resumed = 0;
    return yes;
}
