// Something that is done when a block is left.
#pragma once
#include <utility>

namespace rcpputils
{
template<class F>
class scope_exit
{
public:
  explicit scope_exit(F && call)
  : call_(std::forward<F>(call)) {}
  scope_exit(const scope_exit &) = delete;
  scope_exit(scope_exit && other)
  : call_(std::forward<F>(other.call_)), cancelled_(other.cancelled_) {other.cancelled_ = true;}
  ~scope_exit()
  {
    if (!cancelled_) {
      call_();
    }
  }
  void cancel() {cancelled_ = true;}

private:
  F call_;
  bool cancelled_ = false;
};
template<class F>
scope_exit<F> make_scope_exit(F && call) {return scope_exit<F>(std::forward<F>(call));}
}  // namespace rcpputils
#define RCPPUTILS_SCOPE_EXIT(code) \
  auto RCPPUTILS_SCOPE_EXIT_NAME(__LINE__) = rcpputils::make_scope_exit([&]() {code;})
#define RCPPUTILS_SCOPE_EXIT_NAME(line) RCPPUTILS_SCOPE_EXIT_NAME_(line)
#define RCPPUTILS_SCOPE_EXIT_NAME_(line) coursekit_scope_exit_ ## line
