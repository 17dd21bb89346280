#include "boards/linux_spi/permission.hpp"

#include <sys/stat.h>

#include <fstream>

namespace shade16::linux_spi {

namespace {

/// Read by hand: getgrgid loads libraries at run time, and a program may be linked statically.
std::string group_name(gid_t id, const std::string& groups) {
    std::ifstream file(groups);
    for (std::string line; std::getline(file, line);) {
        const std::size_t name = line.find(':'), password = line.find(':', name + 1), number = line.find(':', password + 1);
        if (number == std::string::npos) continue;
        if (line.substr(password + 1, number - password - 1) == std::to_string(id)) return line.substr(0, name);
    }
    return std::to_string(id);
}

}  // namespace

host::Error permission_denied(const std::string& what, const std::string& device, const std::string& usual_group, const std::string& groups) {
    struct stat status {};
    const bool known = stat(device.c_str(), &status) == 0;
    if (known && status.st_gid != 0 && (status.st_mode & 060) == 060) {
        const std::string group = group_name(status.st_gid, groups);
        return host::io_error("{}: {} is open to group '{}' alone, and this user is not in it; 'sudo adduser $USER {}' and a new login mend it.", what, device,
                              group, group);
    }
    return host::io_error(
        "{}: {} is open to root alone; 'sudo chgrp {} {}' and 'sudo chmod g+rw {}' (or a udev rule that does so at every start), "
        "'sudo adduser $USER {}' and a new login mend it.",
        what, device, usual_group, device, device, usual_group);
}

}  // namespace shade16::linux_spi
