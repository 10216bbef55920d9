// What ncp.hpp promises beyond ncp.h: one owner, exceptions, and nothing that is cut at a NUL.
#include <ncp.hpp>

#include <cstdio>
#include <type_traits>

template <typename... T>
constexpr bool only_move =
    ((!std::is_copy_constructible_v<T> && !std::is_copy_assignable_v<T> &&
      std::is_nothrow_move_constructible_v<T> && std::is_nothrow_move_assignable_v<T>)&&...);

static_assert(only_move<ncp::governor, ncp::watchdog, ncp::action_buffer, ncp::link_monitor,
                        ncp::rate_codec, ncp::reflex, ncp::control_loop, ncp::session_service,
                        ncp::block>);

static int failures = 0;

static void check(bool holds, const char *what) {
    if (!holds) {
        std::printf("%s\n", what);
        ++failures;
    }
}

/// Whether a call throws an error with this code.
template <typename F>
static bool throws(const char *code, F call) {
    try {
        call();
    } catch (const ncp::error &error) {
        return error.code() == code && *error.what() != '\0';
    }
    return false;
}

int main() {
    ncp::governor first("{}");
    first.note_link(true);
    ncp::governor second = std::move(first);
    check(second.is_stopped(), "a governor that was moved keeps its latch");
    check(throws("missing", [&] { first.is_stopped(); }), "one that was moved from throws");
    first = std::move(second);
    check(first.is_stopped(), "and can be moved to again");
    check(throws("malformed", [] { ncp::governor governor("{"); }), "limits that are none throw");
    check(throws("missing", [&] { first.govern("{}", 1.0); }), "a command says its mode");

    ncp::watchdog watchdog;
    watchdog.on_command(1.0, 100.0, 1);
    check(!watchdog.should_hold(1.0), "a fresh command is followed");
    const ncp::watchdog taken = std::move(watchdog);
    check(watchdog.should_hold(1.0), "a watchdog that was moved from holds");
    ncp::action_buffer buffer;
    const ncp::action_buffer kept = std::move(buffer);
    check(buffer.is_stopped(), "a buffer that was moved from is stopped");
    check(throws("missing", [&] { buffer.active(1.0); }), "and has no channels");

    const std::string cut("{}\0 and more", 12);
    check(throws("invalid", [&] { ncp::encode("sensor_frame", cut); }), "fields are not cut at a NUL");
    const std::string frame = R"({"kind":"sensor_frame","seq":1})";
    check(!ncp::decode("sensor_frame", frame).empty(), "a frame is read");
    const auto longer = [&] { ncp::decode("sensor_frame", frame + '\0'); };
    check(throws("malformed", longer), "and not cut at a NUL either");
    check(throws("version", [] { ncp::check_version(std::string_view(OWN_VERSION "\0", sizeof OWN_VERSION)); }), "nor a version");
    check(throws("key", [] { ncp::keys().sensor(std::string_view("u\0", 2)); }), "nor an id");
    check(throws("key", [] { ncp::keys().sensor(std::string_view()); }), "an empty id is none");

    check(ncp::contract_status(std::nullopt) == ncp::contract::not_advertised, "no hash");
    check(ncp::contract_status("") == ncp::contract::mismatch, "an empty hash is one");
    check(ncp::negotiate(OWN_VERSION, ncp::contract_hash()) == ncp::contract::match, "our own hash");

    const std::vector<float> values{1.5F, -0.0F};
    const std::string bytes = ncp::encode_block({ncp::column("v", values)});
    const ncp::block block(bytes);
    check(block[0].values<float>() == values, "floats come back");
    check(throws("block", [&] { block[0].values<double>(); }), "as floats only");
    check(throws("invalid", [&] { block[1]; }), "there is one column");
    check(!block.find("w"), "of another name");
    check(throws("block", [] { ncp::observation::unpack(""); }), "nothing is no block");
    check(ncp::observation::unpack(ncp::observation().pack()).times.empty(), "no spikes");

    std::printf("%d failures\n", failures);
    return failures != 0;
}
