// Matrices of Eigen as OpenCV's, and the other way; Eigen is included before, as with OpenCV.
#pragma once
#include "opencv2/core.hpp"

namespace cv
{
template<class T, int m, int n, int options, int most_rows, int most_columns>
void eigen2cv(const Eigen::Matrix<T, m, n, options, most_rows, most_columns> & src, OutputArray dst)
{
  Mat made(static_cast<int>(src.rows()), static_cast<int>(src.cols()), DataType<T>::type);
  for (int i = 0; i < made.rows * made.cols; ++i) {
    made.at<T>(i / made.cols, i % made.cols) = src(i / made.cols, i % made.cols);
  }
  dst.assign(made);
}
template<class T, int m, int n, int options, int most_rows, int most_columns>
void eigen2cv(const Eigen::Matrix<T, m, n, options, most_rows, most_columns> & src, Matx<T, m, n> & dst)
{
  for (int i = 0; i < m * n; ++i) {
    dst.val[i] = src(i / n, i % n);
  }
}
/// Into a matrix of any size that Eigen lets grow, else into one of this size.
template<class T, int m, int n, int options, int most_rows, int most_columns>
void cv2eigen(const Mat & src, Eigen::Matrix<T, m, n, options, most_rows, most_columns> & dst)
{
  Mat same;
  src.convertTo(same, DataType<T>::depth);
  dst.resize(same.rows, same.cols);
  for (int i = 0; i < same.rows * same.cols; ++i) {
    dst(i / same.cols, i % same.cols) = same.at<T>(i / same.cols, i % same.cols);
  }
}
template<class T, int m, int n, int options, int most_rows, int most_columns>
void cv2eigen(const Matx<T, m, n> & src, Eigen::Matrix<T, m, n, options, most_rows, most_columns> & dst)
{
  for (int i = 0; i < m * n; ++i) {
    dst(i / n, i % n) = src.val[i];
  }
}
}  // namespace cv
