/* The seed's functions with a codec, in the form that every NCP build reads, and in no other: what is there under
 * other names is ignored. They come before the archive's own, so that the linker takes these. */
#include <ncp.h>

#include <string.h>

static ncp_codec *published(const char *codec) {
    static const char *const others[] = {"\"encoders\"", "\"decoders\"", "\"rate_range\""};
    size_t i;

    if (codec[0] != '{') return NULL;
    for (i = 0; i < sizeof others / sizeof others[0]; i++)
        if (strstr(codec, others[i])) codec = "{}";
    return ncp_codec_new(codec);
}

char *ncp_encode_rates(const char *codec, const char *sensor) {
    ncp_codec *read = published(codec);
    char *fields = ncp_validate("sensor_frame", sensor);
    char *rates = read && fields ? ncp_codec_encode(read, fields) : NULL;

    ncp_string_free(fields);
    ncp_codec_free(read);
    return rates;
}

char *ncp_decode_command(const char *codec, const char *rates, double t, int64_t seq, const char *frame_id,
                         const char *mode) {
    ncp_codec *read = published(codec);
    char *fields = read ? ncp_codec_decode(read, rates, t, seq, frame_id, mode) : NULL;
    char *command = fields ? ncp_encode("command_frame", fields) : NULL;

    ncp_string_free(fields);
    ncp_codec_free(read);
    return command;
}
