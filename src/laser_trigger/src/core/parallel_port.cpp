// Copyright 2026 the scan cell developers
// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_port.h"

#include <fcntl.h>
#include <linux/ppdev.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <future>
#include <thread>

namespace laser_trigger {
namespace {

[[noreturn]] void fail(const std::string& device, int error) {
  switch (error) {
    case EACCES:
    case EPERM:
      throw NoPermission(device, "permission denied",
                         "add the user to the group that owns it (lp) and log in again");
    case EBUSY:
    case EAGAIN:
      throw DeviceBusy(device, "held by another program",
                       "stop that program, or unload the printer driver (rmmod lp)");
    case ENOTTY:
    case EINVAL:
      throw NoDevice(device, "not a parallel port",
                     "give the port's device, such as /dev/parport0");
    case ENOENT:
    case ENXIO:
    case ENODEV:
      throw NoDevice(device, "no such device",
                     "check the port in the BIOS and load the drivers (modprobe parport_pc ppdev)");
    default:
      throw scan_cell_common::ConnectionError(device, std::strerror(error),
                                              "check the port and its driver");
  }
}

}  // namespace

ParallelPort::ParallelPort(const std::string& device)
    : device_(device), descriptor_(open(device.c_str(), O_RDWR | O_CLOEXEC)) {
  if (descriptor_.number() < 0) fail(device, errno);
}

ParallelPort::~ParallelPort() {
  if (claimed_) ioctl(descriptor_.number(), PPRELEASE);
}

void ParallelPort::claim(double timeout) {
  if (claimed_) return;
  // The kernel waits for the port forever, so a separate thread does the waiting; an abandoned
  // thread keeps a duplicate of the descriptor until the process ends.
  const int descriptor = dup(descriptor_.number());
  auto claimed = std::make_shared<std::promise<int>>();
  std::future<int> answer = claimed->get_future();
  std::thread([descriptor, claimed] {
    const int error = ioctl(descriptor, PPCLAIM) == 0 ? 0 : errno;
    close(descriptor);
    claimed->set_value(error);
  }).detach();
  if (answer.wait_for(std::chrono::duration<double>(timeout)) != std::future_status::ready) {
    fail(device_, EBUSY);
  }
  const int error = answer.get();
  if (error != 0) fail(device_, error);
  claimed_ = true;
}

void ParallelPort::write(std::uint8_t data) {
  constexpr double kPatience = 2;  // [s] chosen
  claim(kPatience);
  if (ioctl(descriptor_.number(), PPWDATA, &data) != 0) fail(device_, errno);
}

}  // namespace laser_trigger
