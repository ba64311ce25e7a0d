// Filters one after the other, as one filter.
#pragma once
#include <vector>

#include "message_filters/pass_through.h"

namespace message_filters
{
/// A chain of messages of any type: its filters by their number.
class ChainBase
{
public:
  virtual ~ChainBase() = default;
  /// The filter of that number, which must be an F; null where there are fewer.
  template<class F>
  std::shared_ptr<F> getFilter(size_t index) const {return std::static_pointer_cast<F>(getFilterForIndex(index));}

protected:
  virtual std::shared_ptr<void> getFilterForIndex(size_t index) const = 0;
};
using ChainBasePtr = std::shared_ptr<ChainBase>;

template<class M>
class Chain : public ChainBase, public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<M const>;
  Chain() = default;
  template<class F>
  explicit Chain(F & from) {connectInput(from);}
  ~Chain() override {incoming_.disconnect();}

  /// Append a filter that somebody else keeps; its number.
  template<class F>
  size_t addFilter(F * filter) {return addFilter(std::shared_ptr<F>(filter, [](F *) {}));}
  template<class F>
  size_t addFilter(const std::shared_ptr<F> & filter)
  {
    Part part;
    part.filter = filter;
    part.add = [raw = filter.get()](const EventType & event) {raw->add(event);};
    part.output = std::make_shared<PassThrough<M>>(*filter);
    last_.disconnect();
    last_ = part.output->registerCallback([this](const EventType & event) {this->signalMessage(event);});
    if (!parts_.empty()) {
      filter->connectInput(*parts_.back().output);
    }
    parts_.push_back(part);
    return parts_.size() - 1;
  }
  template<class F>
  void connectInput(F & from)
  {
    incoming_.disconnect();
    incoming_ = from.registerCallback(
      std::function<void (const EventType &)>([this](const EventType & event) {add(event);}));
  }
  void add(const MConstPtr & message) {add(EventType(message));}
  void add(const EventType & event)
  {
    if (!parts_.empty()) {
      parts_[0].add(event);
    }
  }

protected:
  std::shared_ptr<void> getFilterForIndex(size_t index) const override
  {
    return index < parts_.size() ? parts_[index].filter : nullptr;
  }

private:
  struct Part
  {
    std::shared_ptr<void> filter;
    std::function<void (const EventType &)> add;
    std::shared_ptr<PassThrough<M>> output;
  };
  std::vector<Part> parts_;
  Connection incoming_, last_;
};
}  // namespace message_filters
