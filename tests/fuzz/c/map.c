/* Passes the input as a channel map to the bridge's reader (vi-crt-bridge/bridge/channel_map.c), which accepts or rejects it and must not
 * read beyond its bytes. */
#include "channel_map.h"
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    dashpot_channel_map map;
    dashpot_channel_map_fault fault;
    char name[DASHPOT_CHANNEL_NAME + 8];
    /* The text has its own block without a closing zero, so that reading one byte too far leaves the block. */
    char *text = malloc(size ? size : 1);
    int answer, channel;
    uint32_t corner;

    if (!text)
        return 0;
    memcpy(text, data, size);
    dashpot_channel_map_default(&map);
    answer = dashpot_channel_map_read(&map, text, size, &fault);
    if (answer && !memchr(fault.text, 0, sizeof fault.text))
        abort();
    for (channel = 0; channel < DASHPOT_CHANNELS; channel++)
        for (corner = 0; corner < 4; corner++)
            if (!dashpot_channel_map_name(&map, (enum dashpot_channel)channel, corner, name, sizeof name - (size_t)channel) &&
                !memchr(name, 0, sizeof name))
                abort();
    free(text);
    return 0;
}
