/* NCP for C++17: the objects and functions of ncp.h with owners and exceptions.
 *
 * Every function throws ncp::error instead of returning NULL or -1. Objects are movable, not copyable,
 * and free what they own; one thread at a time may use an object. A moved-from object throws, and a
 * watchdog or a buffer that has been moved from holds the plant.
 *
 * Texts are UTF-8. Those that have no length in C (JSON, names) must not hold a NUL: that throws too.
 */
#ifndef NCP_HPP
#define NCP_HPP

#include "ncp.h"

#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ncp {

/// Why a call failed: what() in words, code() in one word, as ncp_last_error_code has it.
class error : public std::runtime_error {
public:
    error(std::string code, const std::string &message)
        : std::runtime_error(message), code_(std::move(code)) {}

    const std::string &code() const noexcept { return code_; }

private:
    std::string code_;
};

namespace detail {

[[noreturn]] inline void fail() {
    const char *code = ncp_last_error_code();
    const char *message = ncp_last_error();
    throw error(code ? code : "invalid", message ? message : "the library refused");
}

inline std::int32_t checked(std::int32_t code) {
    if (code == -1) {
        fail();
    }
    return code;
}

/// Takes over a string of the library, and frees it whatever happens.
inline std::string taken(char *text) {
    if (text == nullptr) {
        fail();
    }
    const std::unique_ptr<char, void (*)(char *)> owner(text, ncp_string_free);
    return std::string(text);
}

/// A text as C has it: one with a NUL would be cut there.
inline const char *c(const std::string &text) {
    if (text.find('\0') != std::string::npos) {
        throw error("invalid", "a text holds a NUL");
    }
    return text.c_str();
}

inline const char *c(const std::optional<std::string> &text) {
    return text ? c(*text) : nullptr;
}

inline const char *data(const std::optional<std::string_view> &text) {
    // An empty view may point nowhere, and NULL stands for none.
    return !text ? nullptr : text->data() ? text->data() : "";
}

inline std::size_t size(const std::optional<std::string_view> &text) {
    return text ? text->size() : 0;
}

inline const std::uint8_t *bytes(std::string_view text) {
    return reinterpret_cast<const std::uint8_t *>(text.data() ? text.data() : "");
}

inline const double *pointer(const std::optional<double> &value) {
    return value ? &*value : nullptr;
}

/// The owner of an object of the library.
template <typename T, void (*Free)(T *)>
class handle {
public:
    explicit handle(T *object) : object_(object) {
        if (object == nullptr) {
            fail();
        }
    }

    T *get() const noexcept { return object_.get(); }

private:
    struct deleter {
        void operator()(T *object) const noexcept { Free(object); }
    };
    std::unique_ptr<T, deleter> object_;
};

} // namespace detail

/// The version of the wire, such as "1.2".
inline std::string version() { return detail::taken(ncp_version()); }

/// The hash of the contract that the library keeps.
inline std::string contract_hash() { return detail::taken(ncp_contract_hash()); }

/// The realm of keys for which none is named.
inline std::string default_realm() { return detail::taken(ncp_default_realm()); }

/// The version of the library itself.
inline std::string library_version() { return detail::taken(ncp_library_version()); }

/// Whether a peer of this version can be talked to. If strict, throws when it cannot.
inline bool check_version(std::string_view version, bool strict = false) {
    const std::optional<std::string_view> text(version);
    return detail::checked(ncp_check_version_n(detail::data(text), version.size(), strict)) == 1;
}

/// How a peer's contract hash relates to ours.
enum class contract { not_advertised = 0, match = 1, mismatch = 2 };

inline contract contract_status(std::optional<std::string_view> hash) {
    const auto code = ncp_contract_status_n(detail::data(hash), detail::size(hash));
    return static_cast<contract>(detail::checked(code));
}

/// The strict opt-in: throws unless the peer's hash is ours.
inline void verify_contract(std::optional<std::string_view> hash) {
    detail::checked(ncp_verify_contract(detail::data(hash), detail::size(hash)));
}

/// The version gate, which throws, then the status of the contract.
inline contract negotiate(std::string_view version, std::optional<std::string_view> hash) {
    const std::optional<std::string_view> text(version);
    return static_cast<contract>(detail::checked(ncp_negotiate(
        detail::data(text), version.size(), detail::data(hash), detail::size(hash))));
}

/// Reads a frame of one kind from the wire, and gives it with every field.
inline std::string decode(const std::string &kind, std::string_view frame) {
    return detail::taken(ncp_decode(detail::c(kind), detail::bytes(frame), frame.size()));
}

/// Writes the frame of this kind whose fields a program set.
inline std::string encode(const std::string &kind, const std::string &fields) {
    return detail::taken(ncp_encode(detail::c(kind), detail::c(fields)));
}

/// All fields of a message of which a program set some.
inline std::string build(const std::string &kind, const std::string &fields) {
    return detail::taken(ncp_build(detail::c(kind), detail::c(fields)));
}

/// Throws unless a reply fits its request and reports success.
inline void check_reply(std::string_view request, std::string_view reply) {
    detail::checked(ncp_check_reply(detail::bytes(request), request.size(), detail::bytes(reply),
                                    reply.size()));
}

/// Whether a key expression matches a key.
inline bool key_matches(std::string_view pattern, std::string_view key) {
    const std::optional<std::string_view> first(pattern), second(key);
    return detail::checked(ncp_key_matches(detail::data(first), pattern.size(),
                                           detail::data(second), key.size())) == 1;
}

/// The longest horizon of steps of dt_ms that is of use within ttl_ms.
inline std::size_t max_horizon_len(double ttl_ms, double dt_ms) {
    return ncp_max_horizon_len(ttl_ms, dt_ms);
}

/// How a plane is sent.
struct plane_qos {
    std::string congestion;
    std::string priority;
    bool express;

    /// Of control, perception, action or observation.
    static plane_qos of(const std::string &plane) {
        ncp_plane_qos_t qos;
        detail::checked(ncp_plane_qos(detail::c(plane), &qos));
        return {qos.congestion, qos.priority, qos.express};
    }
};

/// The keys of a realm.
class keys {
public:
    using text = std::optional<std::string_view>;

    explicit keys(std::optional<std::string> realm = std::nullopt) : realm_(std::move(realm)) {}

    std::string rpc() const { return key("rpc"); }
    std::string sensor(std::string_view session, text name = {}) const {
        return key("sensor", session, name);
    }
    std::string command(std::string_view session, text name = {}) const {
        return key("command", session, name);
    }
    std::string observation(std::string_view session) const { return key("observation", session); }
    std::string sensor_glob(std::string_view session) const { return key("sensor_glob", session); }
    std::string command_glob(std::string_view session) const { return key("command_glob", session); }
    std::string session_glob(std::string_view session) const { return key("session_glob", session); }
    std::string fleet_glob() const { return key("fleet_glob"); }

private:
    std::string key(const char *which, text session = {}, text name = {}) const {
        const text realm = realm_ ? text(*realm_) : std::nullopt;
        return detail::taken(ncp_key(which, detail::data(realm), detail::size(realm),
                                     detail::data(session), detail::size(session),
                                     detail::data(name), detail::size(name)));
    }

    std::optional<std::string> realm_;
};

/// Stands at the end of a control loop and lets a command pass only when it is safe.
class governor {
public:
    /// For the canonical channels.
    explicit governor(const std::string &limits) : handle_(ncp_governor_new(detail::c(limits))) {}

    /// For the limits and the channels that a plant declares.
    static governor from_capabilities(const std::string &capabilities) {
        return governor(handle(ncp_governor_from_capabilities(detail::c(capabilities))));
    }

    /// What may be sent of a command, which says its mode, as all of its fields. When it throws, send
    /// nothing.
    std::string govern(const std::string &command, double now_s,
                       const std::optional<std::string> &sensor = std::nullopt,
                       const std::optional<double> &last_sensor_s = std::nullopt) {
        return detail::taken(ncp_governor_govern(handle_.get(), detail::c(command), now_s,
                                                 detail::c(sensor),
                                                 detail::pointer(last_sensor_s)));
    }

    void note_link(bool burst) { detail::checked(ncp_governor_note_link(handle_.get(), burst)); }
    void reset() { detail::checked(ncp_governor_reset(handle_.get())); }
    bool is_stopped() const { return detail::checked(ncp_governor_is_stopped(handle_.get())) == 1; }
    bool has_config_fault() const {
        return detail::checked(ncp_governor_has_config_fault(handle_.get())) == 1;
    }

private:
    using handle = detail::handle<ncp_governor, ncp_governor_free>;
    explicit governor(handle &&owner) : handle_(std::move(owner)) {}
    handle handle_;
};

/// Tells a plant to hold when commands stay away.
class watchdog {
public:
    watchdog() : handle_(ncp_watchdog_new()) {}

    /// Takes note of a command; whether it refreshes the deadline.
    bool on_command(double now_s, double ttl_ms, std::int64_t seq) {
        return detail::checked(ncp_watchdog_on_command(handle_.get(), now_s, ttl_ms, seq)) == 1;
    }

    /// Whether the plant has to hold. Never throws: an error holds.
    bool should_hold(double now_s) noexcept {
        return ncp_watchdog_should_hold(handle_.get(), now_s) != 0;
    }

    void reset() { detail::checked(ncp_watchdog_reset(handle_.get())); }

private:
    detail::handle<ncp_watchdog, ncp_watchdog_free> handle_;
};

/// Keeps the newest command and replays its horizon.
class action_buffer {
public:
    action_buffer() : handle_(ncp_buffer_new()) {}

    /// Takes a command_frame as it arrives. Throws if it is rejected; a torn ESTOP is not, and latches.
    void on_frame(std::string_view frame, double now_s) {
        detail::checked(
            ncp_buffer_on_frame(handle_.get(), detail::bytes(frame), frame.size(), now_s));
    }

    /// The channels that the plant actuates, or none when it holds.
    std::optional<std::string> active(double now_s) {
        char *channels = nullptr;
        if (detail::checked(ncp_buffer_active(handle_.get(), now_s, &channels)) == 0) {
            return std::nullopt;
        }
        return detail::taken(channels);
    }

    /// Whether ESTOP is latched. Never throws: an error stops.
    bool is_stopped() const noexcept { return ncp_buffer_is_stopped(handle_.get()) != 0; }
    void reset() { detail::checked(ncp_buffer_reset(handle_.get())); }

private:
    detail::handle<ncp_buffer, ncp_buffer_free> handle_;
};

/// How a stream arrives.
using link_report = ncp_link_report_t;

/// Counts what a stream loses, and sees a burst of losses.
class link_monitor {
public:
    explicit link_monitor(const std::optional<double> &ref_loss = std::nullopt,
                          const std::optional<double> &threshold = std::nullopt)
        : handle_(ncp_link_new(detail::pointer(ref_loss), detail::pointer(threshold))) {}

    void on_frame(std::int64_t seq) { detail::checked(ncp_link_on_frame(handle_.get(), seq)); }

    link_report report() const {
        link_report report;
        detail::checked(ncp_link_report(handle_.get(), &report));
        return report;
    }

private:
    detail::handle<ncp_link, ncp_link_free> handle_;
};

/// Ties components of channels to populations of neurons.
class rate_codec {
public:
    /// From its JSON text, as ncp_codec_new has it.
    explicit rate_codec(const std::string &codec) : handle_(ncp_codec_new(detail::c(codec))) {}

    /// The default UAV codec.
    static rate_codec uav() { return rate_codec("\"uav\""); }

    std::string encode(const std::optional<std::string> &sensor) const {
        return detail::taken(ncp_codec_encode(handle_.get(), detail::c(sensor)));
    }

    std::string decode(const std::string &rates, double t, std::int64_t seq,
                       const std::string &frame_id, const std::string &mode) const {
        return detail::taken(ncp_codec_decode(handle_.get(), detail::c(rates), t, seq,
                                              detail::c(frame_id), detail::c(mode)));
    }

private:
    detail::handle<ncp_codec, ncp_codec_free> handle_;
};

/// Steers towards a target.
class reflex {
public:
    explicit reflex(const std::string &config = "{}") : handle_(ncp_reflex_new(detail::c(config))) {}

    std::string step(double now_s, const std::optional<std::string> &sensor) {
        return detail::taken(ncp_reflex_step(handle_.get(), now_s, detail::c(sensor)));
    }

private:
    detail::handle<ncp_reflex, ncp_reflex_free> handle_;
};

/// The newest sensor in, one governed command out, a tick at a time.
class control_loop {
public:
    /// What a tick sends.
    struct tick_result {
        std::string command;
        std::string status;
    };

    control_loop(double period_ms, const std::string &limits, const std::string &config = "{}")
        : handle_(ncp_loop_new(period_ms, detail::c(limits), detail::c(config))) {}

    /// Takes every sensor frame that arrives; whether it is the newest.
    bool on_sensor(const std::string &sensor, double now_s) {
        return detail::checked(ncp_loop_on_sensor(handle_.get(), detail::c(sensor), now_s)) == 1;
    }

    tick_result tick(double now_s, double took_ms = 0.0) {
        char *command = nullptr;
        char *status = nullptr;
        detail::checked(ncp_loop_tick(handle_.get(), now_s, took_ms, &command, &status));
        const std::unique_ptr<char, void (*)(char *)> second(status, ncp_string_free);
        std::string sent = detail::taken(command);
        return {std::move(sent), std::string(second.get())};
    }

    void reset() { detail::checked(ncp_loop_reset(handle_.get())); }

private:
    detail::handle<ncp_loop, ncp_loop_free> handle_;
};

/// Serves sessions over the reference backend.
class session_service {
public:
    session_service() : handle_(ncp_service_new()) {}

    /// The one reply to a request, whatever its bytes.
    std::string serve(std::string_view request) {
        return detail::taken(
            ncp_service_serve(handle_.get(), detail::bytes(request), request.size()));
    }

private:
    detail::handle<ncp_service, ncp_service_free> handle_;
};

/// The column type of a C++ type.
template <typename T>
constexpr std::int32_t dtype_of() {
    if constexpr (std::is_same_v<T, float>) {
        return NCP_F32;
    } else if constexpr (std::is_same_v<T, double>) {
        return NCP_F64;
    } else if constexpr (std::is_same_v<T, std::int32_t>) {
        return NCP_I32;
    } else {
        static_assert(std::is_same_v<T, std::int64_t>, "a column is f32, f64, i32 or i64");
        return NCP_I64;
    }
}

/// A column of a block that was read, lent by its bytes.
class column_view {
public:
    explicit column_view(const ncp_column &column) : column_(column) {}

    std::string_view name() const { return {column_.name, column_.name_len}; }
    std::int32_t dtype() const { return column_.dtype; }
    std::size_t rows() const { return column_.rows; }
    const ncp_column &raw() const { return column_; }

    /// A copy of the values, on a little-endian machine. Throws if T is not the column's type.
    template <typename T>
    std::vector<T> values() const {
        if (dtype_of<T>() != column_.dtype) {
            throw error("block", "the column is of another type");
        }
        std::vector<T> values(column_.rows);
        if (!values.empty()) {
            std::memcpy(values.data(), column_.data, values.size() * sizeof(T));
        }
        return values;
    }

private:
    ncp_column column_;
};

/// A checked block: a view of bytes, which have to outlive it.
class block {
public:
    explicit block(std::string_view bytes)
        : handle_(ncp_block_parse(detail::bytes(bytes), bytes.size())) {}

    std::size_t size() const { return ncp_block_columns(handle_.get()); }

    column_view operator[](std::size_t index) const {
        ncp_column column;
        detail::checked(ncp_block_column(handle_.get(), index, &column));
        return column_view(column);
    }

    /// A column by its name, or none.
    std::optional<column_view> find(std::string_view name) const {
        for (std::size_t index = 0; index < size(); ++index) {
            const column_view column = (*this)[index];
            if (column.name() == name) {
                return column;
            }
        }
        return std::nullopt;
    }

private:
    detail::handle<ncp_block, ncp_block_free> handle_;
};

/// A column to be written, lent by a vector that has to outlive it.
template <typename T>
ncp_column column(std::string_view name, const std::vector<T> &values) {
    return {name.data() ? name.data() : "", name.size(), dtype_of<T>(), values.size(),
            values.data()};
}

namespace detail {

inline std::string taken_block(std::uint8_t *block, std::size_t len) {
    if (block == nullptr) {
        fail();
    }
    const auto free = [len](std::uint8_t *bytes) { ncp_bytes_free(bytes, len); };
    const std::unique_ptr<std::uint8_t, decltype(free)> owner(block, free);
    return std::string(reinterpret_cast<const char *>(block), len);
}

} // namespace detail

/// Writes the block of these columns.
inline std::string encode_block(const std::vector<ncp_column> &columns) {
    std::size_t len = 0;
    std::uint8_t *block = ncp_block_encode(columns.data(), columns.size(), &len);
    return detail::taken_block(block, len);
}

/// The arrays of an observation.
struct observation {
    std::vector<double> times;
    std::vector<double> values;
    std::vector<std::int64_t> senders;

    /// Writes them as a block.
    std::string pack() const {
        std::size_t len = 0;
        std::uint8_t *block =
            ncp_observation_pack(times.data(), times.size(), values.data(), values.size(),
                                 senders.data(), senders.size(), &len);
        return detail::taken_block(block, len);
    }

    /// Reads them from a block.
    static observation unpack(std::string_view block) {
        const detail::handle<ncp_arrays, ncp_arrays_free> arrays(
            ncp_observation_unpack(detail::bytes(block), block.size()));
        const auto copy = [&arrays](auto lend) {
            std::size_t count = 0;
            const auto *first = lend(arrays.get(), &count);
            return std::vector<std::decay_t<decltype(*first)>>(first, first + count);
        };
        return {copy(ncp_arrays_times), copy(ncp_arrays_values), copy(ncp_arrays_senders)};
    }
};

} // namespace ncp

#endif // NCP_HPP
