// Angles and the way from one to another, in radians.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace angles
{
static inline double from_degrees(double degrees) {return degrees * M_PI / 180.0;}
static inline double to_degrees(double radians) {return radians * 180.0 / M_PI;}

/// The same direction within 0 ... 2 pi.
static inline double normalize_angle_positive(double angle)
{
  double rest = std::fmod(angle, 2.0 * M_PI);
  return rest < 0 ? rest + 2.0 * M_PI : rest;
}
/// The same direction within -pi ... pi.
static inline double normalize_angle(double angle)
{
  double positive = normalize_angle_positive(angle);
  return positive > M_PI ? positive - 2.0 * M_PI : positive;
}
/// By how much to turn from one angle to another, the short way: -pi ... pi.
static inline double shortest_angular_distance(double from, double to) {return normalize_angle(to - from);}
/// The same direction the other way round.
static inline double two_pi_complement(double angle)
{
  double rest = std::abs(angle) > 2.0 * M_PI ? std::fmod(angle, 2.0 * M_PI) : angle;
  return rest > 0 ? rest - 2.0 * M_PI : rest + 2.0 * M_PI;
}

/// Whether an angle lies between the limits, and how far it may turn back and forth until it meets one.
static inline bool find_min_max_delta(
  double from, double left_limit, double right_limit, double & result_min_delta, double & result_max_delta)
{
  double to_left = shortest_angular_distance(from, left_limit), to_right = shortest_angular_distance(from, right_limit);
  auto [back, forth_to_left] = std::minmax({to_left, two_pi_complement(to_left)});
  auto [back_to_right, forth] = std::minmax({to_right, two_pi_complement(to_right)});
  result_min_delta = to_left == 0 ? 0 : back;
  result_max_delta = to_right == 0 && to_left != 0 ? 0 : forth;
  if (to_left == 0 || to_right == 0 || (back > back_to_right && forth < forth_to_left)) {
    return true;
  }
  result_min_delta = back_to_right;  // the other limit is met first
  result_max_delta = forth_to_left;
  return left_limit == -M_PI && right_limit == M_PI;
}

/// Whether a turn stays between two limits within -pi ... pi, and that turn; else the one that goes less beyond them.
static inline bool shortest_angular_distance_with_limits(
  double from, double to, double left_limit, double right_limit, double & shortest_angle)
{
  double turn = shortest_angular_distance(from, to), other = two_pi_complement(turn), least, most;
  bool inside = find_min_max_delta(from, left_limit, right_limit, least, most);
  for (double way : {turn, other}) {
    if (inside && least <= way && way <= most) {
      shortest_angle = way;
      return true;
    }
  }
  auto [back, forth] = std::minmax({turn, other});
  if (inside) {  // the end lies beyond a limit: which one is nearer to it?
    find_min_max_delta(to, left_limit, right_limit, least, most);
    std::swap(back, forth);
  }
  if (std::abs(least) == std::abs(most)) {
    shortest_angle = std::abs(turn) < std::abs(other) ? turn : other;
  } else {
    shortest_angle = std::abs(least) < std::abs(most) ? back : forth;
  }
  return false;
}
static inline bool shortest_angular_distance_with_limits(double from, double to, double left_limit, double right_limit)
{
  double turn;
  return shortest_angular_distance_with_limits(from, to, left_limit, right_limit, turn);
}
/// The same for limits that may lie beyond pi, of a joint that turns more than once; the left is the lower one.
static inline bool shortest_angular_distance_with_large_limits(
  double from, double to, double left_limit, double right_limit, double & shortest_angle)
{
  double turn = shortest_angular_distance(from, to), other = two_pi_complement(turn);
  if (std::abs(other) < std::abs(turn)) {
    std::swap(turn, other);
  }
  shortest_angle = turn;
  for (double way : {turn, other}) {
    if (left_limit <= right_limit && left_limit <= from + way && from + way <= right_limit) {
      shortest_angle = way;
      return left_limit <= from && from <= right_limit;
    }
  }
  return false;
}
}  // namespace angles
