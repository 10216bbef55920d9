/* NCP for C. Generated from the Rust sources by `cargo xtask generate`; do not edit.
 *
 * Strings that come back belong to the caller: free them with ncp_string_free. NULL, or -1, is an
 * error; ncp_last_error says why. A NULL or a text that is not UTF-8 where a text is required is
 * always an error.
 *
 * Objects are made by ..._new and freed by ..._free, once; NULL there is nothing. One thread at a
 * time may use an object; different objects are independent.
 *
 * Messages are JSON texts. A "frame" is what travels, and is read as strictly as the wire wants it.
 * "Fields" are what a program sets and sees: an object named and nested as on the wire, in which a
 * double may also be "NaN", "Infinity" or "-Infinity". Times are seconds on one monotonic clock.
 */


#ifndef NCP_H
#define NCP_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// IEEE 754 binary32.
#define NCP_F32 1

// IEEE 754 binary64.
#define NCP_F64 2

// Two's complement, 32 bits.
#define NCP_I32 3

// Two's complement, 64 bits.
#define NCP_I64 4

// The arrays of an observation that came as a block.
typedef struct ncp_arrays ncp_arrays;

// A checked block: a view of the caller's bytes.
typedef struct ncp_block ncp_block;

// Keeps the newest command and replays its horizon.
typedef struct ncp_buffer ncp_buffer;

// Ties components of channels to populations of neurons.
typedef struct ncp_codec ncp_codec;

// Stands at the end of a control loop and lets a command pass only when it is safe.
typedef struct ncp_governor ncp_governor;

// Counts what a stream loses, and sees a burst of losses.
typedef struct ncp_link ncp_link;

// The newest sensor in, one governed command out, a tick at a time.
typedef struct ncp_loop ncp_loop;

// Steers towards a target.
typedef struct ncp_reflex ncp_reflex;

// Serves sessions. One thread at a time may use it.
typedef struct ncp_service ncp_service;

// Tells a plant to hold when commands stay away.
typedef struct ncp_watchdog ncp_watchdog;

// How a plane is sent. The texts live as long as the program.
typedef struct {
    // "block" or "drop".
    const char *congestion;
    // "Data", "DataHigh" or "RealTime".
    const char *priority;
    // Whether messages are sent at once, without batching.
    bool express;
} ncp_plane_qos_t;

// A column of a block, lent: by the block when it is read, by the caller when it is written.
typedef struct {
    // The name, UTF-8, without a NUL at its end.
    const char *name;
    // Bytes of the name.
    size_t name_len;
    // The type of the values: NCP_F32, NCP_F64, NCP_I32 or NCP_I64.
    int32_t dtype;
    // Number of values.
    size_t rows;
    // The values. In a column that is written: in the machine's own order, aligned. In one that was read:
    // little-endian, and at any address, so copy them with memcpy before they are used.
    const void *data;
} ncp_column;

// How a stream arrives.
typedef struct {
    // The highest seq that was seen.
    int64_t last_seq;
    // Frames that arrived.
    int64_t received;
    // Frames that are missing.
    int64_t lost;
    // Lost of those expected, 0 to 1.
    double loss_rate;
    // Whether losses come in a burst.
    bool burst;
} ncp_link_report_t;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// The version of the wire, such as "1.2".
char *ncp_version(void);

// The realm that a NULL realm stands for.
char *ncp_default_realm(void);

// Whether a peer of this version can be talked to: 1 yes, 0 no, -1 error. With strict other than 0,
// "no" is an error.
int32_t ncp_check_version(const char *version, int32_t strict);

// The hash of the contract that this library keeps.
char *ncp_contract_hash(void);

// How a peer's hash relates to ours: 1 it matches, 0 it is not advertised (NULL), 2 it differs. -1 is a
// hash that is not UTF-8.
int32_t ncp_contract_status(const char *peer_hash);

// The key of the control RPC.
char *ncp_key_rpc(const char *realm);

// The key of a session's sensor stream.
char *ncp_key_sensor(const char *realm, const char *session);

// The key of a session's command stream.
char *ncp_key_command(const char *realm, const char *session);

// The key of a session's observations.
char *ncp_key_observation(const char *realm, const char *session);

// The rates in Hz by population, a JSON object, for a codec and a sensor_frame. For a sensor that is not
// there, see ncp_codec_encode.
//
// The codec is that of every NCP build: an object with encoder and decoder, arrays of mappings with population,
// channel (of a decoder command_channel) and, if need be, component, value_range, rate_range_hz, unit; members
// that are not known are ignored. Or it is one as ncp_codec_new takes it.
char *ncp_encode_rates(const char *codec,
                       const char *sensor);

// The command_frame for a codec and rates. A NULL frame_id is "world", a NULL mode "active"; a mode that
// is not known, or not UTF-8, is an error.
char *ncp_decode_command(const char *codec,
                         const char *rates,
                         double t,
                         int64_t seq,
                         const char *frame_id,
                         const char *mode);

// What may be sent of a command_frame, under limits, at now_s, in the light of a sensor_frame (or NULL)
// that was received at last_sensor_s (negative: none yet), both in seconds on one clock. The decision
// stands alone; a latch needs ncp_governor. On NULL send nothing, so that the plant holds.
char *ncp_govern(const char *limits,
                 const char *command,
                 double now_s,
                 const char *sensor,
                 double last_sensor_s);

// Reads a frame of one kind as strictly as the wire does, and writes it again with every field. NULL is a
// frame that is rejected. For a frame that may hold a NUL, as one from a network, use ncp_decode.
char *ncp_validate(const char *kind,
                   const char *json);

// Frees a string that this library returned. NULL is nothing.
// The string came from this library, and is not used again.
void ncp_string_free(char *string);

// Why the last call on this thread that failed did so, in words, or NULL if none has failed. It is
// lent: the next failure on this thread ends it, so copy what is to last.
const char *ncp_last_error(void);

// The same reason in one word: malformed, type, kind, missing, value, provenance, limit, version,
// contract, key, block, non_finite, reply, invalid; or internal, which is a defect of this library.
// Lent like the message.
const char *ncp_last_error_code(void);

// The version of the functions that this library offers beyond the 14 of every NCP build: 1. A program
// that loads a library at run time asks for it before it uses them.
int32_t ncp_extension_version(void);

// The version of this library itself.
char *ncp_library_version(void);

// Like ncp_check_version, for a version that a peer sent.
// The version has that many bytes.
int32_t ncp_check_version_n(const char *version, size_t version_len, int32_t strict);

// Like ncp_contract_status, for a hash that a peer sent. NULL of length 0: it sent none.
// The hash has that many bytes.
int32_t ncp_contract_status_n(const char *hash, size_t hash_len);

// The strict opt-in: 1 if the peer's hash is ours, -1 if not or if there is none.
// The hash has that many bytes.
int32_t ncp_verify_contract(const char *hash, size_t hash_len);

// The version gate, then the status of the contract: 1, 0 or 2 as ncp_contract_status; -1 if the version
// is refused.
// The version and the hash have that many bytes.
int32_t ncp_negotiate(const char *version,
                      size_t version_len,
                      const char *hash,
                      size_t hash_len);

// Reads a frame of one kind, as strictly as the wire does, and writes it again with every field. NULL is a
// frame that is rejected; an empty string one that was read, but that no frame can hold.
// The frame has that many bytes.
char *ncp_decode(const char *kind,
                 const uint8_t *frame,
                 size_t frame_len);

// Writes the frame of this kind whose fields a program set: a JSON object, named and nested as on the
// wire. A field that is left out has the default of a program, so the mode of a command is "active".
// NULL is a message that no frame can hold.
char *ncp_encode(const char *kind,
                 const char *fields);

// All fields of a message of which a program set some, as in ncp_encode, but unchecked: a number that JSON
// lacks may stand there as "NaN", "Infinity" or "-Infinity".
char *ncp_build(const char *kind,
                const char *fields);

// What a client does with a reply: 1 it is accepted, -1 it does not fit the request, or reports a failure.
// The request and the reply have that many bytes.
int32_t ncp_check_reply(const uint8_t *request,
                        size_t request_len,
                        const uint8_t *reply,
                        size_t reply_len);

// A key or key expression: rpc, sensor, command, observation, sensor_glob, command_glob, session_glob,
// fleet_glob. A NULL realm is the default one. rpc and fleet_glob have no session; sensor and command may
// have a name.
// The texts have that many bytes.
char *ncp_key(const char *key,
              const char *realm,
              size_t realm_len,
              const char *session,
              size_t session_len,
              const char *name,
              size_t name_len);

// Whether a key expression matches a key: 1 yes, 0 no, -1 if one of them is none.
// The texts have that many bytes.
int32_t ncp_key_matches(const char *pattern, size_t pattern_len, const char *key, size_t key_len);

// How a plane is sent: control (the RPC), perception, action, observation. 1, or -1 for another name.
int32_t ncp_plane_qos(const char *plane,
                      ncp_plane_qos_t *qos);

// Checks a block and lends views of it, or NULL if it breaks a rule. The bytes must stay as they are until
// ncp_block_free. Views may be read by many threads at once.
// There are that many bytes, and they outlive the view.
ncp_block *ncp_block_parse(const uint8_t *block,
                           size_t block_len);

// The number of columns; 0 for NULL.
size_t ncp_block_columns(const ncp_block *block);

// A column by its place in the directory, from 0: 1, or -1 past the last.
int32_t ncp_block_column(const ncp_block *block, size_t index, ncp_column *column);

// Frees a view, not the bytes of the block. NULL is nothing.
void ncp_block_free(ncp_block *block);

// Writes the block of these columns, which the caller frees with ncp_bytes_free, or NULL.
// There are that many columns, and of each as many values of its type, and bytes of its name, as it says.
uint8_t *ncp_block_encode(const ncp_column *columns,
                          size_t count,
                          size_t *block_len);

// Writes the block of an observation's arrays, which the caller frees with ncp_bytes_free, or NULL if they
// do not agree. An array may be NULL if it is empty.
// The arrays have that many values.
uint8_t *ncp_observation_pack(const double *times,
                              size_t times_len,
                              const double *values,
                              size_t values_len,
                              const int64_t *senders,
                              size_t senders_len,
                              size_t *block_len);

// Reads the arrays of an observation, or NULL if the block is rejected. They are copies.
// The block has that many bytes.
ncp_arrays *ncp_observation_unpack(const uint8_t *block, size_t block_len);

// The times in ms, lent by the arrays, and how many.
const double *ncp_arrays_times(const ncp_arrays *arrays, size_t *count);

// The values, lent by the arrays, and how many.
const double *ncp_arrays_values(const ncp_arrays *arrays, size_t *count);

// The senders, lent by the arrays, and how many.
const int64_t *ncp_arrays_senders(const ncp_arrays *arrays, size_t *count);

// Frees the arrays. NULL is nothing.
void ncp_arrays_free(ncp_arrays *arrays);

// Frees a block that this library wrote. NULL is nothing.
// The block came from this library with this length, and is not used again.
void ncp_bytes_free(uint8_t *block, size_t block_len);

// A governor with these limits, a JSON object, for the canonical channels. A limit that it does not know
// is an error.
ncp_governor *ncp_governor_new(const char *limits);

// A governor for the limits and the channels that a plant declares: the fields of capabilities.
ncp_governor *ncp_governor_from_capabilities(const char *capabilities);

// What may be sent of a command, as all of its fields; ncp_encode makes the frame. The command says its
// mode. The sensor may be NULL; last_sensor_s is when it was received, on the clock of now_s, in seconds,
// or NULL for none yet. On NULL send nothing, so that the plant holds; an ESTOP latches even so.
char *ncp_governor_govern(ncp_governor *governor,
                          const char *command,
                          double now_s,
                          const char *sensor,
                          const double *last_sensor_s);

// Takes note of the link: a burst of losses (other than 0) latches ESTOP. 1, or -1.
int32_t ncp_governor_note_link(ncp_governor *governor, int32_t burst);

// Clears the latch, by a supervisor's decision. A config fault stays. 1, or -1.
int32_t ncp_governor_reset(ncp_governor *governor);

// Whether ESTOP is latched: 1 yes, 0 no, -1 error.
int32_t ncp_governor_is_stopped(ncp_governor *governor);

// Whether a limit cannot act on the channels, so that this governor always holds: 1 yes, 0 no, -1 error.
int32_t ncp_governor_has_config_fault(ncp_governor *governor);

// Frees a governor. NULL is nothing.
void ncp_governor_free(ncp_governor *governor);

// A watchdog that has seen no command, so that it holds.
ncp_watchdog *ncp_watchdog_new(void);

// Takes note of a command: received at now_s in seconds, live for ttl_ms. 1 if its seq advances, so that it
// refreshes the deadline, else 0; -1 error.
int32_t ncp_watchdog_on_command(ncp_watchdog *watchdog,
                                double now_s,
                                double ttl_ms,
                                int64_t seq);

// Whether the plant has to hold at now_s: 0 is no, and everything else is yes, an error (-1) too.
int32_t ncp_watchdog_should_hold(ncp_watchdog *watchdog, double now_s);

// Forgets everything, by a supervisor's decision: it holds until a new command comes. 1, or -1.
int32_t ncp_watchdog_reset(ncp_watchdog *watchdog);

// Frees a watchdog. NULL is nothing.
void ncp_watchdog_free(ncp_watchdog *watchdog);

// A buffer without a command.
ncp_buffer *ncp_buffer_new(void);

// Takes a command_frame as it arrives, at now_s. 1, or -1 if it is rejected. An ESTOP latches however torn its
// frame is, which is 1.
// The frame has that many bytes.
int32_t ncp_buffer_on_frame(ncp_buffer *buffer,
                            const uint8_t *frame,
                            size_t frame_len,
                            double now_s);

// What the plant does at now_s: 1 and its channels, a JSON object that the caller frees; 0 and NULL when it
// holds; -1 and NULL on an error, which holds as well.
int32_t ncp_buffer_active(ncp_buffer *buffer,
                          double now_s,
                          char **channels);

// Clears the latch, the held command and the last seq, by a supervisor's decision: nothing moves until a
// new command comes. 1, or -1.
int32_t ncp_buffer_reset(ncp_buffer *buffer);

// Whether ESTOP is latched: 0 is no, and everything else is yes, an error (-1) too.
int32_t ncp_buffer_is_stopped(ncp_buffer *buffer);

// Frees a buffer. NULL is nothing.
void ncp_buffer_free(ncp_buffer *buffer);

// The longest horizon of steps of dt_ms that is of use within ttl_ms; 0 for what are no durations.
size_t ncp_max_horizon_len(double ttl_ms, double dt_ms);

// A monitor that has seen nothing. NULL is the default: a loss of 0.05 that is taken for normal, and a
// threshold of 5.
ncp_link *ncp_link_new(const double *ref_loss,
                       const double *threshold);

// Takes note of a frame: every one that arrives. 1, or -1.
int32_t ncp_link_on_frame(ncp_link *link, int64_t seq);

// How the stream arrives so far. 1, or -1.
int32_t ncp_link_report(ncp_link *link, ncp_link_report_t *report);

// Frees a monitor. NULL is nothing.
void ncp_link_free(ncp_link *link);

// A codec from its JSON text: "uav" in quotes for the default one, or an object of encoders and decoders,
// arrays of mappings: channel, component, population, and, if need be, value_range, rate_range, unit. An
// object without them is read as ncp_encode_rates reads one.
ncp_codec *ncp_codec_new(const char *codec);

// The rates in Hz by population, a JSON object, for the fields of a sensor frame, or NULL for none.
char *ncp_codec_encode(const ncp_codec *codec, const char *sensor);

// All fields of the command for these rates. NULL for frame_id and mode is as in ncp_decode_command.
char *ncp_codec_decode(const ncp_codec *codec,
                       const char *rates,
                       double t,
                       int64_t seq,
                       const char *frame_id,
                       const char *mode);

// Frees a codec. NULL is nothing.
void ncp_codec_free(ncp_codec *codec);

// A controller from a JSON object with any of target (three metres), kp, kd, max_speed. Gains that cannot
// be used are an error.
ncp_reflex *ncp_reflex_new(const char *config);

// All fields of the command for the fields of a sensor frame, or NULL for none, at now_s in seconds.
char *ncp_reflex_step(ncp_reflex *reflex,
                      double now_s,
                      const char *sensor);

// Frees a controller. NULL is nothing.
void ncp_reflex_free(ncp_reflex *reflex);

// A loop of a reflex controller, a governor with the canonical channels, and a link monitor, that ticks
// every period_ms.
ncp_loop *ncp_loop_new(double period_ms,
                       const char *limits,
                       const char *config);

// Takes the fields of a sensor frame, every one that arrives, at now_s. 1 if it is the newest, else 0; -1
// error.
int32_t ncp_loop_on_sensor(ncp_loop *control,
                           const char *sensor,
                           double now_s);

// One tick at now_s: all fields of the command and of the status that are to be sent, which the caller
// frees. took_ms is how long the tick before it took. 1; or -1, and both are NULL: send nothing, so that
// the plant holds.
int32_t ncp_loop_tick(ncp_loop *control,
                      double now_s,
                      double took_ms,
                      char **command,
                      char **status);

// Clears the latch of the governor, by a supervisor's decision. 1, or -1.
int32_t ncp_loop_reset(ncp_loop *control);

// Frees a loop. NULL is nothing.
void ncp_loop_free(ncp_loop *control);

// A service without sessions, over the reference backend.
ncp_service *ncp_service_new(void);

// The one reply to a request, whatever its bytes. NULL only if the service itself is at fault.
// The request has that many bytes.
char *ncp_service_serve(ncp_service *service, const uint8_t *request, size_t request_len);

// Frees a service and its sessions. NULL is nothing.
void ncp_service_free(ncp_service *service);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* NCP_H */
