// The functions of ncp.h once more, under the prefix face_, each of them written with ncp.hpp alone: what the
// C++ header cannot express, this library cannot answer. The adapter of peers/cpp loads it.

#include <ncp.hpp>

#include <cstdlib>
#include <exception>

#define FACE(type) extern "C" __attribute__((visibility("default"))) type

namespace {

thread_local std::string last_code;
thread_local std::string last_message;

/// Does something in C++, and tells C of it when it throws.
template <typename T, typename F>
T guarded(T failed, F call) noexcept {
    try {
        return call();
    } catch (const ncp::error &refused) {
        last_code = refused.code();
        last_message = refused.what();
    } catch (const std::exception &broken) {
        last_code = "internal";
        last_message = broken.what();
    }
    return failed;
}

/// A text for C, which gives it back to face_string_free.
char *out(const std::string &text) {
    auto *copy = static_cast<char *>(std::malloc(text.size() + 1));
    if (copy == nullptr) {
        throw std::bad_alloc();
    }
    std::memcpy(copy, text.c_str(), text.size() + 1);
    return copy;
}

template <typename F>
char *text(F call) noexcept {
    return guarded<char *>(nullptr, [&] { return out(call()); });
}

/// What a function without a result says when nothing was thrown.
template <typename F>
std::int32_t done(F call) noexcept {
    return guarded<std::int32_t>(-1, [&] {
        call();
        return 1;
    });
}

template <typename F>
std::int32_t code(F call) noexcept {
    return guarded<std::int32_t>(-1, [&] { return static_cast<std::int32_t>(call()); });
}

template <typename T, typename F>
T *made(F make) noexcept {
    // Made in one place and moved to another, as programs do.
    return guarded<T *>(nullptr, [&] {
        T object = make();
        return new T(std::move(object));
    });
}

std::string_view view(const std::uint8_t *bytes, std::size_t len) {
    return {reinterpret_cast<const char *>(bytes), len};
}

std::optional<std::string_view> maybe(const char *text, std::size_t len) {
    return text == nullptr ? std::nullopt : std::optional(std::string_view(text, len));
}

std::optional<std::string> maybe(const char *text) {
    return text == nullptr ? std::nullopt : std::optional<std::string>(text);
}

std::optional<double> maybe(const double *value) {
    return value == nullptr ? std::nullopt : std::optional(*value);
}

/// A block, by a name of its own: `ncp_block` is C's.
struct parsed_block {
    ncp::block block;
};

std::uint8_t *block_out(const std::string &block, std::size_t *len) {
    *len = block.size();
    auto *copy = static_cast<std::uint8_t *>(std::malloc(block.size()));
    if (copy == nullptr) {
        throw std::bad_alloc();
    }
    std::memcpy(copy, block.data(), block.size());
    return copy;
}

} // namespace

FACE(std::int32_t) face_extension_version() { return ncp_extension_version(); }
FACE(const char *) face_last_error() { return last_message.c_str(); }
FACE(const char *) face_last_error_code() { return last_code.c_str(); }
FACE(void) face_string_free(char *string) { std::free(string); }
FACE(void) face_bytes_free(std::uint8_t *bytes, std::size_t) { std::free(bytes); }

FACE(char *) face_version() { return text([] { return ncp::version(); }); }
FACE(char *) face_contract_hash() { return text([] { return ncp::contract_hash(); }); }
FACE(char *) face_default_realm() { return text([] { return ncp::default_realm(); }); }
FACE(char *) face_library_version() { return text([] { return ncp::library_version(); }); }

FACE(std::int32_t)
face_check_version_n(const char *version, std::size_t len, std::int32_t strict) {
    return code([&] { return ncp::check_version({version, len}, strict != 0); });
}

FACE(std::int32_t) face_contract_status_n(const char *hash, std::size_t len) {
    return code([&] { return ncp::contract_status(maybe(hash, len)); });
}

FACE(std::int32_t) face_verify_contract(const char *hash, std::size_t len) {
    return done([&] { ncp::verify_contract(maybe(hash, len)); });
}

FACE(std::int32_t)
face_negotiate(const char *version, std::size_t version_len, const char *hash,
               std::size_t hash_len) {
    return code([&] { return ncp::negotiate({version, version_len}, maybe(hash, hash_len)); });
}

FACE(char *) face_decode(const char *kind, const std::uint8_t *frame, std::size_t len) {
    return text([&] { return ncp::decode(kind, view(frame, len)); });
}

FACE(char *) face_encode(const char *kind, const char *fields) {
    return text([&] { return ncp::encode(kind, fields); });
}

FACE(char *) face_build(const char *kind, const char *fields) {
    return text([&] { return ncp::build(kind, fields); });
}

FACE(std::int32_t)
face_check_reply(const std::uint8_t *request, std::size_t request_len, const std::uint8_t *reply,
                 std::size_t reply_len) {
    return done([&] { ncp::check_reply(view(request, request_len), view(reply, reply_len)); });
}

FACE(char *)
face_key(const char *key, const char *realm, std::size_t realm_len, const char *session,
         std::size_t session_len, const char *name, std::size_t name_len) {
    return text([&]() -> std::string {
        const std::string_view which(key), id(session ? session : "", session_len);
        const auto named = maybe(name, name_len);
        const auto text = maybe(realm, realm_len);
        const ncp::keys keys(text ? std::optional<std::string>(*text) : std::nullopt);
        return which == "rpc"            ? keys.rpc()
               : which == "sensor"       ? keys.sensor(id, named)
               : which == "command"      ? keys.command(id, named)
               : which == "observation"  ? keys.observation(id)
               : which == "sensor_glob"  ? keys.sensor_glob(id)
               : which == "command_glob" ? keys.command_glob(id)
               : which == "session_glob" ? keys.session_glob(id)
                                         : keys.fleet_glob();
    });
}

FACE(std::int32_t)
face_key_matches(const char *pattern, std::size_t pattern_len, const char *key,
                 std::size_t key_len) {
    return code([&] { return ncp::key_matches({pattern, pattern_len}, {key, key_len}); });
}

FACE(std::int32_t) face_plane_qos(const char *plane, ncp_plane_qos_t *qos) {
    return done([&] {
        // The texts have to last: there are four planes.
        thread_local ncp::plane_qos last;
        last = ncp::plane_qos::of(plane);
        *qos = {last.congestion.c_str(), last.priority.c_str(), last.express};
    });
}

FACE(std::size_t) face_max_horizon_len(double ttl_ms, double dt_ms) {
    return ncp::max_horizon_len(ttl_ms, dt_ms);
}

FACE(parsed_block *) face_block_parse(const std::uint8_t *bytes, std::size_t len) {
    return made<parsed_block>([&] { return parsed_block{ncp::block(view(bytes, len))}; });
}

FACE(std::size_t) face_block_columns(const parsed_block *block) { return block->block.size(); }

FACE(std::int32_t)
face_block_column(const parsed_block *block, std::size_t index, ncp_column *column) {
    return done([&] {
        const ncp::column_view view = block->block[index];
        const auto found = block->block.find(view.name());
        *column = found.value().raw();
    });
}

FACE(void) face_block_free(parsed_block *block) { delete block; }

FACE(std::uint8_t *)
face_block_encode(const ncp_column *columns, std::size_t count, std::size_t *len) {
    return guarded<std::uint8_t *>(nullptr, [&] {
        return block_out(ncp::encode_block({columns, columns + count}), len);
    });
}

FACE(std::uint8_t *)
face_observation_pack(const double *times, std::size_t times_len, const double *values,
                      std::size_t values_len, const std::int64_t *senders,
                      std::size_t senders_len, std::size_t *len) {
    return guarded<std::uint8_t *>(nullptr, [&] {
        const ncp::observation observation{{times, times + times_len},
                                           {values, values + values_len},
                                           {senders, senders + senders_len}};
        return block_out(observation.pack(), len);
    });
}

FACE(ncp::observation *) face_observation_unpack(const std::uint8_t *block, std::size_t len) {
    return made<ncp::observation>([&] { return ncp::observation::unpack(view(block, len)); });
}

FACE(const double *) face_arrays_times(const ncp::observation *arrays, std::size_t *count) {
    *count = arrays->times.size();
    return arrays->times.data();
}

FACE(const double *) face_arrays_values(const ncp::observation *arrays, std::size_t *count) {
    *count = arrays->values.size();
    return arrays->values.data();
}

FACE(const std::int64_t *) face_arrays_senders(const ncp::observation *arrays, std::size_t *count) {
    *count = arrays->senders.size();
    return arrays->senders.data();
}

FACE(void) face_arrays_free(ncp::observation *arrays) { delete arrays; }

FACE(ncp::governor *) face_governor_new(const char *limits) {
    return made<ncp::governor>([&] { return ncp::governor(limits); });
}

FACE(ncp::governor *) face_governor_from_capabilities(const char *capabilities) {
    return made<ncp::governor>([&] { return ncp::governor::from_capabilities(capabilities); });
}

FACE(char *)
face_governor_govern(ncp::governor *governor, const char *command, double now_s, const char *sensor,
                     const double *last_sensor_s) {
    return text(
        [&] { return governor->govern(command, now_s, maybe(sensor), maybe(last_sensor_s)); });
}

FACE(std::int32_t) face_governor_note_link(ncp::governor *governor, std::int32_t burst) {
    return done([&] { governor->note_link(burst != 0); });
}

FACE(std::int32_t) face_governor_reset(ncp::governor *governor) {
    return done([&] { governor->reset(); });
}

FACE(void) face_governor_free(ncp::governor *governor) { delete governor; }

FACE(ncp::watchdog *) face_watchdog_new() {
    return made<ncp::watchdog>([] { return ncp::watchdog(); });
}

FACE(std::int32_t)
face_watchdog_on_command(ncp::watchdog *watchdog, double now_s, double ttl_ms, std::int64_t seq) {
    return code([&] { return watchdog->on_command(now_s, ttl_ms, seq); });
}

FACE(std::int32_t) face_watchdog_should_hold(ncp::watchdog *watchdog, double now_s) {
    return watchdog->should_hold(now_s);
}

FACE(std::int32_t) face_watchdog_reset(ncp::watchdog *watchdog) {
    return done([&] { watchdog->reset(); });
}

FACE(void) face_watchdog_free(ncp::watchdog *watchdog) { delete watchdog; }

FACE(ncp::action_buffer *) face_buffer_new() {
    return made<ncp::action_buffer>([] { return ncp::action_buffer(); });
}

FACE(std::int32_t)
face_buffer_on_frame(ncp::action_buffer *buffer, const std::uint8_t *frame, std::size_t len,
                     double now_s) {
    return done([&] { buffer->on_frame(view(frame, len), now_s); });
}

FACE(std::int32_t)
face_buffer_active(ncp::action_buffer *buffer, double now_s, char **channels) {
    return code([&] {
        const auto active = buffer->active(now_s);
        *channels = active ? out(*active) : nullptr;
        return active.has_value();
    });
}

FACE(std::int32_t) face_buffer_reset(ncp::action_buffer *buffer) {
    return done([&] { buffer->reset(); });
}

FACE(void) face_buffer_free(ncp::action_buffer *buffer) { delete buffer; }

FACE(ncp::link_monitor *) face_link_new(const double *ref_loss, const double *threshold) {
    return made<ncp::link_monitor>(
        [&] { return ncp::link_monitor(maybe(ref_loss), maybe(threshold)); });
}

FACE(std::int32_t) face_link_on_frame(ncp::link_monitor *link, std::int64_t seq) {
    return done([&] { link->on_frame(seq); });
}

FACE(std::int32_t) face_link_report(ncp::link_monitor *link, ncp_link_report_t *report) {
    return done([&] { *report = link->report(); });
}

FACE(void) face_link_free(ncp::link_monitor *link) { delete link; }

FACE(ncp::rate_codec *) face_codec_new(const char *codec) {
    return made<ncp::rate_codec>([&] { return ncp::rate_codec(codec); });
}

FACE(char *) face_codec_encode(const ncp::rate_codec *codec, const char *sensor) {
    return text([&] { return codec->encode(maybe(sensor)); });
}

FACE(char *)
face_codec_decode(const ncp::rate_codec *codec, const char *rates, double t, std::int64_t seq,
                  const char *frame_id, const char *mode) {
    return text([&] { return codec->decode(rates, t, seq, frame_id, mode); });
}

FACE(void) face_codec_free(ncp::rate_codec *codec) { delete codec; }

FACE(ncp::reflex *) face_reflex_new(const char *config) {
    return made<ncp::reflex>([&] { return ncp::reflex(config); });
}

FACE(char *) face_reflex_step(ncp::reflex *reflex, double now_s, const char *sensor) {
    return text([&] { return reflex->step(now_s, maybe(sensor)); });
}

FACE(void) face_reflex_free(ncp::reflex *reflex) { delete reflex; }

FACE(ncp::control_loop *)
face_loop_new(double period_ms, const char *limits, const char *config) {
    return made<ncp::control_loop>([&] { return ncp::control_loop(period_ms, limits, config); });
}

FACE(std::int32_t)
face_loop_on_sensor(ncp::control_loop *control, const char *sensor, double now_s) {
    return code([&] { return control->on_sensor(sensor, now_s); });
}

FACE(std::int32_t)
face_loop_tick(ncp::control_loop *control, double now_s, double took_ms, char **command,
               char **status) {
    return done([&] {
        const ncp::control_loop::tick_result tick = control->tick(now_s, took_ms);
        *command = out(tick.command);
        *status = out(tick.status);
    });
}

FACE(std::int32_t) face_loop_reset(ncp::control_loop *control) {
    return done([&] { control->reset(); });
}

FACE(void) face_loop_free(ncp::control_loop *control) { delete control; }

FACE(ncp::session_service *) face_service_new() {
    return made<ncp::session_service>([] { return ncp::session_service(); });
}

FACE(char *)
face_service_serve(ncp::session_service *service, const std::uint8_t *request, std::size_t len) {
    return text([&] { return service->serve(view(request, len)); });
}

FACE(void) face_service_free(ncp::session_service *service) { delete service; }
