// interactive_markers: a handle that is dragged, and a menu with a check box.
#include <iostream>

#include "interactive_markers/interactive_marker_server.hpp"
#include "interactive_markers/menu_handler.hpp"
#include "rclcpp/rclcpp.hpp"
using interactive_markers::InteractiveMarkerServer;
using interactive_markers::MenuHandler;
using visualization_msgs::msg::InteractiveMarker;
using visualization_msgs::msg::InteractiveMarkerControl;
using visualization_msgs::msg::InteractiveMarkerFeedback;

class Handles : public rclcpp::Node
{
public:
  Handles()
  : Node("handles"), server_(std::make_unique<InteractiveMarkerServer>("handles", this))
  {
    InteractiveMarker marker;
    marker.header.frame_id = "base_link";
    marker.name = "knob";
    marker.description = "A knob";
    InteractiveMarkerControl control;
    control.interaction_mode = InteractiveMarkerControl::MOVE_AXIS;
    marker.controls.push_back(control);
    server_->insert(marker, std::bind(&Handles::dragged, this, std::placeholders::_1));
    first_ = menu_.insert("First", std::bind(&Handles::chosen, this, std::placeholders::_1));
    menu_.setCheckState(menu_.insert(first_, "Below"), MenuHandler::UNCHECKED);
    menu_.setVisible(menu_.insert("Hidden"), false);
    menu_.setCheckState(first_, MenuHandler::CHECKED);
    menu_.apply(*server_, "knob");
    std::cout << server_->empty() << server_->size();
    server_->applyChanges();
    std::cout << server_->empty() << server_->size() << server_->erase("nothing") << server_->setPose("nothing", marker.pose)
              << menu_.apply(*server_, "nothing") << std::endl;
    timer_ = create_wall_timer(
      std::chrono::seconds(4), [this] {
        server_->erase("knob");
        server_->applyChanges();
      });
  }

private:
  void dragged(const InteractiveMarkerFeedback::ConstSharedPtr & feedback)
  {
    std::cout << "kind " << +feedback->event_type << " of " << feedback->marker_name << " at " << feedback->pose.position.x
              << std::endl;
    server_->applyChanges();
  }
  void chosen(const InteractiveMarkerFeedback::ConstSharedPtr & feedback)
  {
    MenuHandler::CheckState state;
    std::string title;
    menu_.getCheckState(feedback->menu_entry_id, state);
    menu_.getTitle(feedback->menu_entry_id, title);
    std::cout << "chosen " << title << (state == MenuHandler::CHECKED ? " checked" : " unchecked") << std::endl;
    menu_.setCheckState(first_, state == MenuHandler::CHECKED ? MenuHandler::UNCHECKED : MenuHandler::CHECKED);
    menu_.reApply(*server_);
    server_->applyChanges();
  }
  std::unique_ptr<InteractiveMarkerServer> server_;
  MenuHandler menu_;
  MenuHandler::EntryHandle first_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Handles>());
  rclcpp::shutdown();
}
