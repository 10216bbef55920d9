// A plant and its commander in C++: the loop of the library flies to a target, and its spikes travel as a
// block.
#include <ncp.hpp>

#include <iostream>

int main() try {
    ncp::control_loop control(50.0, R"({"max_speed_mps":1.5,"geofence_radius_m":5})",
                              R"({"target":[2,0,0]})");
    ncp::action_buffer plant;
    ncp::link_monitor link;

    std::cout << "NCP " << ncp::version() << " on " << ncp::keys("lab").command("uav3") << '\n';
    for (int tick = 1; tick <= 3; ++tick) {
        const double now_s = 0.05 * tick;
        const std::string place = std::to_string(0.5 * tick);
        control.on_sensor(R"({"seq":)" + std::to_string(tick) +
                              R"(,"channels":{"pose_position":{"unit":"m","data":[)" + place +
                              R"(,0,0]}}})",
                          now_s);
        // What goes over the network is a frame; what comes from there is read as strictly as the wire.
        plant.on_frame(ncp::encode("command_frame", control.tick(now_s).command), now_s);
        link.on_frame(tick);
        std::cout << "x=" << place << ": " << plant.active(now_s).value_or("holds") << '\n';
    }
    std::cout << "a second later: " << plant.active(1.2).value_or("holds") << '\n';
    std::cout << "lost " << link.report().lost << " of 3\n";

    for (const char *torn : {R"({"kind":"command_frame","mode":"active","seq":)",
                             R"({"kind":"command_frame","mode":"estop","seq":)"}) {
        try {
            plant.on_frame(torn, 1.3);
        } catch (const ncp::error &rejected) {
            std::cout << rejected.code() << ": " << rejected.what() << '\n';
        }
    }
    std::cout << (plant.is_stopped() ? "a torn ESTOP stops all the same\n" : "it flies on\n");

    const ncp::observation spikes{{1.5, 2.5, 9.0}, {}, {7, 7, 9}};
    const std::string bytes = spikes.pack();
    const ncp::block block(bytes);
    std::cout << bytes.size() << " bytes, " << block.size() << " columns, the last spike at "
              << block.find("times").value().values<double>().back() << " ms\n";
} catch (const ncp::error &failed) {
    std::cerr << failed.code() << ": " << failed.what() << '\n';
    return 1;
}
