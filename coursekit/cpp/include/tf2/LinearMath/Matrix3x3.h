// Matrices of three rows: turns.
#pragma once
#include <utility>

#include "tf2/LinearMath/Quaternion.h"

namespace tf2
{
class Matrix3x3
{
public:
  Matrix3x3() = default;
  explicit Matrix3x3(const Quaternion & q) {setRotation(q);}
  Matrix3x3(
    tf2Scalar xx, tf2Scalar xy, tf2Scalar xz, tf2Scalar yx, tf2Scalar yy, tf2Scalar yz, tf2Scalar zx, tf2Scalar zy, tf2Scalar zz)
  {
    setValue(xx, xy, xz, yx, yy, yz, zx, zy, zz);
  }
  void setValue(
    tf2Scalar xx, tf2Scalar xy, tf2Scalar xz, tf2Scalar yx, tf2Scalar yy, tf2Scalar yz, tf2Scalar zx, tf2Scalar zy, tf2Scalar zz)
  {
    rows_[0] = Vector3(xx, xy, xz);
    rows_[1] = Vector3(yx, yy, yz);
    rows_[2] = Vector3(zx, zy, zz);
  }
  /// From twelve numbers of OpenGL: its three columns, each with a number more.
  void setFromOpenGLSubMatrix(const tf2Scalar * m) {setValue(m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]);}
  void getOpenGLSubMatrix(tf2Scalar * m) const
  {
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 3; ++row) {
        m[4 * column + row] = rows_[row][column];
      }
      m[4 * column + 3] = 0;
    }
  }
  void setIdentity() {setValue(1, 0, 0, 0, 1, 0, 0, 0, 1);}
  static const Matrix3x3 & getIdentity()
  {
    static const Matrix3x3 identity(1, 0, 0, 0, 1, 0, 0, 0, 1);
    return identity;
  }

  void setRotation(const Quaternion & q)
  {
    for (int column = 0; column < 3; ++column) {
      Vector3 axis;
      axis[column] = 1;
      Vector3 turned = quatRotate(q, axis) / q.length2();
      for (int row = 0; row < 3; ++row) {
        rows_[row][column] = turned[row];
      }
    }
  }
  void getRotation(Quaternion & q) const
  {
    // the largest of the four is found first, so that nothing is divided by a small number
    tf2Scalar xx = rows_[0][0], yy = rows_[1][1], zz = rows_[2][2];
    if (xx + yy + zz > 0) {
      q = Quaternion(rows_[2][1] - rows_[1][2], rows_[0][2] - rows_[2][0], rows_[1][0] - rows_[0][1], 1 + xx + yy + zz);
    } else if (xx >= yy && xx >= zz) {
      q = Quaternion(1 + xx - yy - zz, rows_[1][0] + rows_[0][1], rows_[2][0] + rows_[0][2], rows_[2][1] - rows_[1][2]);
    } else if (yy >= zz) {
      q = Quaternion(rows_[1][0] + rows_[0][1], 1 + yy - xx - zz, rows_[2][1] + rows_[1][2], rows_[0][2] - rows_[2][0]);
    } else {
      q = Quaternion(rows_[2][0] + rows_[0][2], rows_[2][1] + rows_[1][2], 1 + zz - xx - yy, rows_[1][0] - rows_[0][1]);
    }
    q.normalize();
  }
  void setRPY(tf2Scalar roll, tf2Scalar pitch, tf2Scalar yaw)
  {
    Quaternion q;
    q.setRPY(roll, pitch, yaw);
    setRotation(q);
  }
  void setEulerZYX(tf2Scalar roll, tf2Scalar pitch, tf2Scalar yaw) {setRPY(roll, pitch, yaw);}
  void setEulerYPR(tf2Scalar yaw, tf2Scalar pitch, tf2Scalar roll) {setRPY(roll, pitch, yaw);}
  /// Roll, pitch and yaw; of the two solutions the second turns pitch over.
  void getRPY(tf2Scalar & roll, tf2Scalar & pitch, tf2Scalar & yaw, unsigned int solution = 1) const
  {
    tf2Scalar sine = -rows_[2][0];
    if (std::fabs(sine) >= 1) {  // pitch is straight up or down, so roll and yaw turn about the same axis
      yaw = 0;
      pitch = sine > 0 ? TF2SIMD_PI / 2 : -TF2SIMD_PI / 2;
      roll = sine > 0 ? std::atan2(rows_[0][1], rows_[0][2]) : std::atan2(-rows_[0][1], -rows_[0][2]);
      return;
    }
    pitch = solution == 2 ? TF2SIMD_PI - std::asin(sine) : std::asin(sine);
    tf2Scalar side = std::cos(pitch);
    roll = std::atan2(rows_[2][1] / side, rows_[2][2] / side);
    yaw = std::atan2(rows_[1][0] / side, rows_[0][0] / side);
  }
  void getEulerYPR(tf2Scalar & yaw, tf2Scalar & pitch, tf2Scalar & roll, unsigned int solution = 1) const
  {
    getRPY(roll, pitch, yaw, solution);
  }
  void getEulerZYX(tf2Scalar & yaw, tf2Scalar & pitch, tf2Scalar & roll, unsigned int solution = 1) const
  {
    getRPY(roll, pitch, yaw, solution);
  }

  Vector3 & operator[](int i) {return rows_[i];}
  const Vector3 & operator[](int i) const {return rows_[i];}
  const Vector3 & getRow(int i) const {return rows_[i];}
  Vector3 getColumn(int i) const {return Vector3(rows_[0][i], rows_[1][i], rows_[2][i]);}
  Vector3 operator*(const Vector3 & v) const {return Vector3(rows_[0].dot(v), rows_[1].dot(v), rows_[2].dot(v));}
  Matrix3x3 operator*(const Matrix3x3 & o) const
  {
    Matrix3x3 product;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        product[row][column] = rows_[row].dot(o.getColumn(column));
      }
    }
    return product;
  }
  Matrix3x3 & operator*=(const Matrix3x3 & o) {return *this = *this * o;}
  bool operator==(const Matrix3x3 & o) const {return rows_[0] == o[0] && rows_[1] == o[1] && rows_[2] == o[2];}
  Matrix3x3 operator+(const Matrix3x3 & o) const {return rows(rows_[0] + o[0], rows_[1] + o[1], rows_[2] + o[2]);}
  Matrix3x3 operator-(const Matrix3x3 & o) const {return rows(rows_[0] - o[0], rows_[1] - o[1], rows_[2] - o[2]);}
  Matrix3x3 & operator+=(const Matrix3x3 & o) {return *this = *this + o;}
  Matrix3x3 & operator-=(const Matrix3x3 & o) {return *this = *this - o;}
  /// With its columns longer by the three factors.
  Matrix3x3 scaled(const Vector3 & s) const {return rows(rows_[0] * s, rows_[1] * s, rows_[2] * s);}
  Matrix3x3 absolute() const {return rows(rows_[0].absolute(), rows_[1].absolute(), rows_[2].absolute());}
  /// The determinant of two rows and columns.
  tf2Scalar cofac(int r1, int c1, int r2, int c2) const {return rows_[r1][c1] * rows_[r2][c2] - rows_[r1][c2] * rows_[r2][c1];}
  Matrix3x3 adjoint() const {return inverse() * determinant();}
  Matrix3x3 operator*(tf2Scalar f) const {return rows(rows_[0] * f, rows_[1] * f, rows_[2] * f);}
  Matrix3x3 transposeTimes(const Matrix3x3 & o) const {return transpose() * o;}
  Matrix3x3 timesTranspose(const Matrix3x3 & o) const {return *this * o.transpose();}
  tf2Scalar tdotx(const Vector3 & v) const {return getColumn(0).dot(v);}
  tf2Scalar tdoty(const Vector3 & v) const {return getColumn(1).dot(v);}
  tf2Scalar tdotz(const Vector3 & v) const {return getColumn(2).dot(v);}
  Matrix3x3 transpose() const
  {
    Vector3 x = getColumn(0), y = getColumn(1), z = getColumn(2);
    return Matrix3x3(x.x(), x.y(), x.z(), y.x(), y.y(), y.z(), z.x(), z.y(), z.z());
  }
  tf2Scalar determinant() const {return rows_[0].dot(rows_[1].cross(rows_[2]));}
  Matrix3x3 inverse() const
  {
    Vector3 x = rows_[1].cross(rows_[2]), y = rows_[2].cross(rows_[0]), z = rows_[0].cross(rows_[1]);
    tf2Scalar s = 1 / determinant();
    return Matrix3x3(x.x() * s, y.x() * s, z.x() * s, x.y() * s, y.y() * s, z.y() * s, x.z() * s, y.z() * s, z.z() * s);
  }
  /// Turn this symmetric matrix until it is diagonal, by Jacobi: before it was rot * this * rot.transpose(). It ends when
  /// what is beside the diagonal is less than the threshold times the sum of the diagonal's sizes, or after so many steps.
  void diagonalize(Matrix3x3 & rot, tf2Scalar threshold, int maxSteps)
  {
    rot.setIdentity();
    for (int step = 0; step < maxSteps; ++step) {
      int p = 0, q = 1;
      for (auto [row, column] : {std::pair(0, 2), std::pair(1, 2)}) {
        if (std::fabs(rows_[row][column]) > std::fabs(rows_[p][q])) {
          p = row;
          q = column;
        }
      }
      tf2Scalar sizes = std::fabs(rows_[0][0]) + std::fabs(rows_[1][1]) + std::fabs(rows_[2][2]);
      if (rows_[p][q] == 0 || std::fabs(rows_[p][q]) < threshold * sizes) {
        return;
      }
      Matrix3x3 turn = turn_that_clears(p, q);
      *this = turn.transpose() * *this * turn;
      rows_[p][q] = rows_[q][p] = 0;  // but for rounding
      rot *= turn;
    }
  }
  void serialize(Matrix3x3Data & data) const {each_row([&](int i) {rows_[i].serialize(data.m_el[i]);});}
  void serializeFloat(Matrix3x3FloatData & data) const {each_row([&](int i) {rows_[i].serializeFloat(data.m_el[i]);});}
  void deSerialize(const Matrix3x3Data & data) {each_row([&](int i) {rows_[i].deSerialize(data.m_el[i]);});}
  void deSerializeDouble(const Matrix3x3DoubleData & data) {deSerialize(data);}
  void deSerializeFloat(const Matrix3x3FloatData & data) {each_row([&](int i) {rows_[i].deSerializeFloat(data.m_el[i]);});}

private:
  template<class F>
  static void each_row(F what)
  {
    for (int row = 0; row < 3; ++row) {
      what(row);
    }
  }
  /// The turn in the plane of two axes after which this matrix has 0 there; the smaller one of the two that do.
  Matrix3x3 turn_that_clears(int p, int q) const
  {
    tf2Scalar angle = std::atan2(2 * rows_[p][q], rows_[q][q] - rows_[p][p]) / 2;
    angle = angle > TF2SIMD_PI / 4 ? angle - TF2SIMD_PI / 2 : angle < -TF2SIMD_PI / 4 ? angle + TF2SIMD_PI / 2 : angle;
    Matrix3x3 turn;
    turn[p][p] = turn[q][q] = std::cos(angle);
    turn[p][q] = std::sin(angle);
    turn[q][p] = -turn[p][q];
    return turn;
  }
  static Matrix3x3 rows(const Vector3 & x, const Vector3 & y, const Vector3 & z)
  {
    return Matrix3x3(x.x(), x.y(), x.z(), y.x(), y.y(), y.z(), z.x(), z.y(), z.z());
  }
  Vector3 rows_[3] = {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)};
};
inline Vector3 operator*(const Vector3 & v, const Matrix3x3 & m) {return Vector3(m.tdotx(v), m.tdoty(v), m.tdotz(v));}
}  // namespace tf2
