// Points of an image that are known again in another one, and what each looks like.
#pragma once
#include <array>

#include "opencv2/core.hpp"
#include "opencv2/imgproc.hpp"

namespace cv
{
/// A point, how large and how turned its surroundings are.
struct KeyPoint
{
  Point2f pt;
  float size = 0, angle = -1, response = 0;
  int octave = 0, class_id = -1;
  KeyPoint() = default;
  KeyPoint(Point2f at, float size_, float angle_ = -1, float response_ = 0, int octave_ = 0, int class_id_ = -1)
  : pt(at), size(size_), angle(angle_), response(response_), octave(octave_), class_id(class_id_) {}
  KeyPoint(float x, float y, float size_, float angle_ = -1, float response_ = 0, int octave_ = 0, int class_id_ = -1)
  : KeyPoint(Point2f(x, y), size_, angle_, response_, octave_, class_id_) {}
  static void convert(const std::vector<KeyPoint> & points, std::vector<Point2f> & places)
  {
    places.clear();
    for (auto & point : points) {
      places.push_back(point.pt);
    }
  }
};
/// Two descriptions that are alike.
struct DMatch
{
  int queryIdx = -1, trainIdx = -1, imgIdx = -1;
  float distance = std::numeric_limits<float>::max();
  DMatch() = default;
  DMatch(int query, int train, float distance_)
  : queryIdx(query), trainIdx(train), distance(distance_) {}
  bool operator<(const DMatch & o) const {return distance < o.distance;}
};

namespace detail
{
/// The numbers of a key point, and of a match, as they cross the link.
inline std::array<double, 7> numbers_of(const KeyPoint & p)
{
  return {p.pt.x, p.pt.y, p.size, p.angle, p.response, double(p.octave), double(p.class_id)};
}
inline std::array<double, 3> numbers_of(const DMatch & m) {return {double(m.queryIdx), double(m.trainIdx), m.distance};}
inline KeyPoint from_numbers(const std::array<double, 7> & v)
{
  return KeyPoint(
    static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2]), static_cast<float>(v[3]),
    static_cast<float>(v[4]), static_cast<int>(v[5]), static_cast<int>(v[6]));
}
inline DMatch from_numbers(const std::array<double, 3> & v)
{
  DMatch match(static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<float>(v[2]));
  match.imgIdx = 0;
  return match;
}
template<class T>
Mat rows_of(const std::vector<T> & all)
{
  Mat rows(static_cast<int>(all.size()), static_cast<int>(numbers_of(T()).size()), CV_64F);
  for (int i = 0; i < rows.rows; ++i) {
    auto numbers = numbers_of(all[static_cast<size_t>(i)]);
    std::memcpy(rows.ptr(i), numbers.data(), sizeof(numbers));
  }
  return rows;
}
template<class T>
void fill_from_rows(std::vector<T> & all, const Mat & rows)
{
  all.clear();
  for (int i = 0; i < rows.rows; ++i) {
    auto numbers = numbers_of(T());
    std::memcpy(numbers.data(), rows.ptr(i), sizeof(numbers));
    all.push_back(from_numbers(numbers));
  }
}
}  // namespace detail

/// What finds key points and describes them: ORB, AKAZE, SIFT and others.
class Feature2D
{
public:
  template<class ... A>
  explicit Feature2D(const char * kind, const A & ... arguments)
  : object_("feature_detector", kind, arguments ...) {}
  void detect(InputArray image, std::vector<KeyPoint> & points, InputArray mask = noArray())
  {
    detail::fill_from_rows(points, object_.call("detect", image, mask).mat);
  }
  void compute(InputArray image, std::vector<KeyPoint> & points, OutputArray descriptors)
  {
    auto found = object_.call("compute", image, detail::rows_of(points));
    detail::fill_from_rows(points, found[0].mat);
    descriptors.assign(found[1]);
  }
  void detectAndCompute(InputArray image, InputArray mask, std::vector<KeyPoint> & points, OutputArray descriptors)
  {
    auto found = object_.call("detectAndCompute", image, mask);
    detail::fill_from_rows(points, found[0].mat);
    descriptors.assign(found[1]);
  }

private:
  remote::Object object_;
};
using FeatureDetector = Feature2D;
using DescriptorExtractor = Feature2D;
#define COURSEKIT_FEATURES(name) \
  class name : public Feature2D \
  { \
  public: \
    using Feature2D::Feature2D; \
    template<class ... A> \
    static Ptr<name> create(A ... arguments) {return makePtr<name>(#name, arguments ...);} \
  };
COURSEKIT_FEATURES(ORB)
COURSEKIT_FEATURES(SIFT)
COURSEKIT_FEATURES(BRISK)
COURSEKIT_FEATURES(AKAZE)
COURSEKIT_FEATURES(FastFeatureDetector)
COURSEKIT_FEATURES(GFTTDetector)
#undef COURSEKIT_FEATURES
inline void FAST(InputArray image, std::vector<KeyPoint> & points, int threshold, bool suppressed = true)
{
  FastFeatureDetector::create(threshold, suppressed)->detect(image, points);
}

/// Finds spots of one colour, by their size and shape.
class SimpleBlobDetector : public Feature2D
{
public:
  struct Params
  {
    float thresholdStep = 10, minThreshold = 50, maxThreshold = 220;
    size_t minRepeatability = 2;
    float minDistBetweenBlobs = 10;
    bool filterByColor = true;
    uchar blobColor = 0;
    bool filterByArea = true;
    float minArea = 25, maxArea = 5000;
    bool filterByCircularity = false;
    float minCircularity = 0.8f, maxCircularity = std::numeric_limits<float>::max();
    bool filterByInertia = true;
    float minInertiaRatio = 0.1f, maxInertiaRatio = std::numeric_limits<float>::max();
    bool filterByConvexity = true;
    float minConvexity = 0.95f, maxConvexity = std::numeric_limits<float>::max();
  };
  using Feature2D::Feature2D;
  static Ptr<SimpleBlobDetector> create(const Params & p) {return made(p);}
  static Ptr<SimpleBlobDetector> create() {return made(Params());}

private:
  static Ptr<SimpleBlobDetector> made(const Params & p)
  {
    return makePtr<SimpleBlobDetector>(
#define COURSEKIT_FIELD(name) remote::kw(#name, p.name)
      "SimpleBlobDetector", COURSEKIT_FIELD(thresholdStep), COURSEKIT_FIELD(minThreshold), COURSEKIT_FIELD(maxThreshold),
      COURSEKIT_FIELD(minRepeatability), COURSEKIT_FIELD(minDistBetweenBlobs), COURSEKIT_FIELD(filterByColor),
      COURSEKIT_FIELD(blobColor), COURSEKIT_FIELD(filterByArea), COURSEKIT_FIELD(minArea), COURSEKIT_FIELD(maxArea),
      COURSEKIT_FIELD(filterByCircularity), COURSEKIT_FIELD(minCircularity), COURSEKIT_FIELD(maxCircularity),
      COURSEKIT_FIELD(filterByInertia), COURSEKIT_FIELD(minInertiaRatio), COURSEKIT_FIELD(maxInertiaRatio),
      COURSEKIT_FIELD(filterByConvexity), COURSEKIT_FIELD(minConvexity), COURSEKIT_FIELD(maxConvexity));
#undef COURSEKIT_FIELD
  }
};

/// Finds for each description the one that is most alike, by trying all.
class BFMatcher
{
public:
  explicit BFMatcher(int norm = NORM_L2, bool crossed = false)
  : norm_(norm), crossed_(crossed) {}
  static Ptr<BFMatcher> create(int norm = NORM_L2, bool crossed = false) {return makePtr<BFMatcher>(norm, crossed);}
  void match(InputArray query, InputArray train, std::vector<DMatch> & matches) const
  {
    detail::fill_from_rows(matches, remote::call("match_features", query, train, norm_, crossed_).mat);
  }
  void knnMatch(InputArray query, InputArray train, std::vector<std::vector<DMatch>> & matches, int k) const
  {
    auto found = remote::call("match_features_knn", query, train, norm_, crossed_, k);
    matches.resize(found.items.size());
    for (size_t i = 0; i < matches.size(); ++i) {
      detail::fill_from_rows(matches[i], found[i].mat);
    }
  }

private:
  int norm_;
  bool crossed_;
};
using DescriptorMatcher = BFMatcher;
/// For descriptions of float: OpenCV's is faster and may miss the nearest, this one does not.
class FlannBasedMatcher : public BFMatcher
{
public:
  FlannBasedMatcher()
  : BFMatcher(NORM_L2) {}
  static Ptr<FlannBasedMatcher> create() {return makePtr<FlannBasedMatcher>();}
};

enum class DrawMatchesFlags {DEFAULT = 0, DRAW_OVER_OUTIMG = 1, NOT_DRAW_SINGLE_POINTS = 2, DRAW_RICH_KEYPOINTS = 4};
inline void drawKeypoints(
  InputArray image, const std::vector<KeyPoint> & points, InputOutputArray out, const Scalar & colour = Scalar::all(-1),
  DrawMatchesFlags flags = DrawMatchesFlags::DEFAULT)
{
  out.assign(remote::call("draw_keypoints", image, detail::rows_of(points), colour, static_cast<int>(flags)));
}
inline void drawMatches(
  InputArray image1, const std::vector<KeyPoint> & points1, InputArray image2, const std::vector<KeyPoint> & points2,
  const std::vector<DMatch> & matches, InputOutputArray out)
{
  out.assign(
    remote::call("draw_matches", image1, detail::rows_of(points1), image2, detail::rows_of(points2), detail::rows_of(matches)));
}
}  // namespace cv
