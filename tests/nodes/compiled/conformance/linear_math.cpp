// Matrices that are made diagonal, what vectors, matrices and transforms are as plain numbers, seconds and covariances.
#include "check.hpp"
#include "tf2/LinearMath/Transform.h"
#include "tf2/convert.h"

static bool near(const tf2::Matrix3x3 & a, const tf2::Matrix3x3 & b)
{
  tf2::Matrix3x3 off = (a - b).absolute();
  return off[0][off[0].maxAxis()] < 1e-9 && off[1][off[1].maxAxis()] < 1e-9 && off[2][off[2].maxAxis()] < 1e-9;
}
static double beside(const tf2::Matrix3x3 & m) {return std::fabs(m[0][1]) + std::fabs(m[0][2]) + std::fabs(m[1][2]);}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const tf2::Matrix3x3 inertia(2.0, -0.4, 0.3, -0.4, 1.5, 0.2, 0.3, 0.2, 4.0);
  tf2::Matrix3x3 main_axes = inertia, turn;
  main_axes.diagonalize(turn, 1e-12, 50);
  check("nothing is beside the diagonal", beside(main_axes) < 1e-9);
  check("the turn leads back", near(turn * main_axes * turn.transpose(), inertia));
  check("the turn is one", near(turn * turn.transpose(), tf2::Matrix3x3::getIdentity()) && turn.determinant() > 0);
  tf2::Matrix3x3 one_step = inertia;
  one_step.diagonalize(turn, 1e-12, 1);
  check("a step clears the largest", one_step[0][1] == 0 && beside(one_step) > 1e-3);
  check("after each step the turn leads back", near(turn * one_step * turn.transpose(), inertia));
  tf2::Matrix3x3 coarse = inertia;
  coarse.diagonalize(turn, 1.0, 50);
  check("what is small enough stays", coarse == inertia && turn == tf2::Matrix3x3::getIdentity());
  tf2::Matrix3x3 round(3, 0, 0, 0, 3, 0, 0, 0, 3);
  round.diagonalize(turn, 0.0, 5);
  check("a diagonal one stays", turn == tf2::Matrix3x3::getIdentity());
  tf2::Matrix3x3 even(1, 2, 0, 2, 1, 0, 0, 0, 5);
  even.diagonalize(turn, 1e-12, 9);
  check("two equal ones part", near(even, tf2::Matrix3x3(-1, 0, 0, 0, 3, 0, 0, 0, 5)) || near(even, tf2::Matrix3x3(3, 0, 0, 0, -1, 0, 0, 0, 5)));

  tf2::Vector3 rows[3], v(1, 2, 3), w(-2, 0.5, 4);
  v.getSkewSymmetricMatrix(&rows[0], &rows[1], &rows[2]);
  check("a cross product as a matrix", tf2::Vector3(rows[0].dot(w), rows[1].dot(w), rows[2].dot(w)) == v.cross(w));

  const tf2::Transform move(tf2::Quaternion(0.1, -0.2, 0.3, 0.4).normalized(), tf2::Vector3(0.5, 0.25, -8));
  tf2::TransformDoubleData numbers;
  move.serialize(numbers);
  equal("a column is in its row", numbers.m_basis.m_el[1].m_floats[2], move.getBasis()[1][2]);
  equal("the shift", numbers.m_origin.m_floats[2], -8.0);
  tf2::Transform back;
  back.deSerialize(numbers);
  check("all digits come back", back == move);
  back = tf2::Transform();
  back.deSerializeDouble(numbers);
  check("by the other name as well", back == move);
  tf2::TransformFloatData short_numbers;
  move.serializeFloat(short_numbers);
  back = tf2::Transform();
  back.deSerializeFloat(short_numbers);
  check("half of the digits come back", back.getOrigin() == move.getOrigin() && !(back.getBasis() == move.getBasis()));
  check("the other half is small", tf2::Vector3(back.getBasis()[0] - move.getBasis()[0]).length() < 1e-6);

  equal("seconds are rounded to nanoseconds", tf2::durationFromSec(2.3).count(), 2300000000);
  equal("before zero, too", tf2::durationFromSec(-0.7).count(), -700000000);
  equal("a late time keeps its nanoseconds", tf2::durationFromSec(1796079600.123456789).count() % 1000000000, 123456717);
  std::array<double, 36> row_by_row{};
  row_by_row[8] = 5;
  auto nested = tf2::covarianceRowMajorToNested(row_by_row);
  equal("a covariance's rows", nested[1][2], 5.0);
  check("and back in a row", tf2::covarianceNestedToRowMajor(nested) == row_by_row);
  rclcpp::shutdown();
}
