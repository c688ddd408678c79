// SPDX-License-Identifier: MIT
// A machine of one's own: it follows each setpoint after a period, and raises an alarm when it is
// told to leave its table.
#include <iostream>
#include <softcnc/softcnc.hpp>

namespace cnc = softcnc;

class Table final : public cnc::Backend {
 public:
  explicit Table(double size) : size_(size) {}

  cnc::Feedback exchange(const cnc::Setpoint& setpoint) noexcept override {
    const cnc::Feedback feedback{position_, setpoint.position.cwiseAbs().maxCoeff() > size_};
    position_ = setpoint.position;
    return feedback;
  }
  void rest() noexcept override { ++rests_; }
  int rests() const noexcept { return rests_; }

 private:
  double size_;  // mm
  cnc::AxisVector position_ = cnc::AxisVector::Zero();
  int rests_ = 0;
};

int main() {
  const auto table = std::make_shared<Table>(50);
  auto session = cnc::Session::on(table, cnc::Machine());
  session.feed("G01 X40 F3000\nM00\nG01 X60\nM30\n");
  session.end();
  double x = 0;
  while (session.status() != cnc::SessionStatus::alarm &&
         session.status() != cnc::SessionStatus::done) {
    const auto row = session.step();
    if (row) x = row->setpoint.position.x();
    if (session.status() == cnc::SessionStatus::paused) session.resume();
  }
  std::cout << (session.status() == cnc::SessionStatus::alarm ? "alarm" : "done") << " at X"
            << static_cast<int>(x) << " after " << table->rests() << " rest\n";
}
