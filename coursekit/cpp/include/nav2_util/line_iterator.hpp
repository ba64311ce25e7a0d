// The cells of a line, one after the other, as Bresenham draws it.
#pragma once
#include <cstdlib>

namespace nav2_util
{
class LineIterator
{
public:
  LineIterator(int x0, int y0, int x1, int y1)
  : x0_(x0), y0_(y0), x1_(x1), y1_(y1), x_(x0), y_(y0),
    wide_(std::abs(x1 - x0)), high_(std::abs(y1 - y0)), right_(x1 >= x0 ? 1 : -1), up_(y1 >= y0 ? 1 : -1),
    steps_(wide_ >= high_ ? wide_ : high_), rest_(steps_ / 2) {}

  bool isValid() const {return step_ <= steps_;}
  void advance()
  {
    ++step_;
    const bool flat = wide_ >= high_;
    (flat ? x_ : y_) += flat ? right_ : up_;
    rest_ += flat ? high_ : wide_;
    if (rest_ >= steps_) {
      rest_ -= steps_;
      (flat ? y_ : x_) += flat ? up_ : right_;
    }
  }
  int getX() const {return x_;}
  int getY() const {return y_;}
  int getX0() const {return x0_;}
  int getY0() const {return y0_;}
  int getX1() const {return x1_;}
  int getY1() const {return y1_;}

private:
  int x0_, y0_, x1_, y1_;
  int x_, y_;
  int wide_, high_;
  int right_, up_;
  int steps_;
  int rest_;
  int step_ = 0;
};
}  // namespace nav2_util
