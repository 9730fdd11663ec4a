#include "veil.h"
#include <stdint.h>
#include <string.h>

/* First line of a veiled text. Two hexadecimal digits per byte follow, with line breaks. */
static const char MARK[] = "veiled 1\n";

static int digit(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

void unveil(char *text, const char *guid)
{
    uint64_t state = 0xcbf29ce484222325u;
    const char *from = text;
    int high = -1;

    if (strncmp(text, MARK, sizeof MARK - 1))
        return;
    /* The FNV-1a hash of the GUID is the seed of xorshift64* (Vigna 2016). Its upper byte is combined with each byte of the
     * text by exclusive or. */
    for (; *guid; guid++)
        state = (state ^ (unsigned char)*guid) * 0x100000001b3u;
    if (!state)
        state = 1;
    for (from += sizeof MARK - 1; *from; from++) {
        int four = digit(*from);

        if (four < 0)
            continue;
        if (high < 0) {
            high = four;
            continue;
        }
        state ^= state >> 12;
        state ^= state << 25;
        state ^= state >> 27;
        *text++ = (char)((unsigned)(16 * high + four) ^ (unsigned)((state * 0x2545f4914f6cdd1du) >> 56));
        high = -1;
    }
    *text = 0;
}
