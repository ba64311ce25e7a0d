// A robot: its links and joints by their names, and the link that all hang on.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "urdf_model/link.h"

namespace urdf
{
class ModelInterface
{
public:
  LinkConstSharedPtr getRoot() const {return root_link_;}
  const std::string & getName() const {return name_;}
  /// A part by its name; null where there is none.
  LinkConstSharedPtr getLink(const std::string & name) const {return found(links_, name);}
  void getLink(const std::string & name, LinkSharedPtr & link) const {link = found(links_, name);}
  JointConstSharedPtr getJoint(const std::string & name) const {return found(joints_, name);}
  MaterialSharedPtr getMaterial(const std::string & name) const {return found(materials_, name);}
  void getLinks(std::vector<LinkSharedPtr> & links) const
  {
    for (auto & entry : links_) {
      links.push_back(entry.second);
    }
  }
  void clear()
  {
    name_.clear();
    links_.clear();
    joints_.clear();
    materials_.clear();
    root_link_.reset();
  }
  /// Hang the links on each other as the joints say, which come in the order of their names. Throws ParseError.
  void initTree(std::map<std::string, std::string> & parent_link_tree)
  {
    for (auto & entry : joints_) {
      const JointSharedPtr & joint = entry.second;
      LinkSharedPtr child = found(links_, joint->child_link_name), parent = found(links_, joint->parent_link_name);
      if (!child || !parent) {
        const char * which = child ? "parent" : "child";
        const std::string & name = child ? joint->parent_link_name : joint->child_link_name;
        throw ParseError(which + (" link [" + name) + "] of joint [" + joint->name + "] not found");
      }
      child->setParent(parent);
      child->parent_joint = joint;
      parent->child_joints.push_back(joint);
      parent->child_links.push_back(child);
      parent_link_tree[child->name] = parent->name;
    }
  }
  /// Find the link that has no parent. Throws ParseError where none has, or several.
  void initRoot(const std::map<std::string, std::string> & parent_link_tree)
  {
    root_link_.reset();
    for (auto & entry : links_) {
      if (parent_link_tree.count(entry.first)) {
        continue;
      }
      if (root_link_) {
        throw ParseError("Two root links found: [" + root_link_->name + "] and [" + entry.first + "]");
      }
      root_link_ = entry.second;
    }
    if (!root_link_) {
      throw ParseError("No root link found. The robot xml is not a valid tree.");
    }
  }

  std::map<std::string, LinkSharedPtr> links_;
  std::map<std::string, JointSharedPtr> joints_;
  std::map<std::string, MaterialSharedPtr> materials_;
  std::string name_;
  LinkSharedPtr root_link_;

private:
  template<class T>
  static std::shared_ptr<T> found(const std::map<std::string, std::shared_ptr<T>> & parts, const std::string & name)
  {
    auto it = parts.find(name);
    return it == parts.end() ? nullptr : it->second;
  }
};
}  // namespace urdf
