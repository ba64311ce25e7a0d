// What programs do with yaml-cpp; the test knows what yaml-cpp 0.7 answers.
#include <fstream>
#include <iostream>
#include "yaml-cpp/yaml.h"

struct Spot
{
  double x = 0, y = 0;
};
namespace YAML
{
template<>
struct convert<Spot>
{
  static Node encode(const Spot & spot)
  {
    Node node;
    node.push_back(spot.x);
    node.push_back(spot.y);
    return node;
  }
  static bool decode(const Node & node, Spot & spot)
  {
    if (!node.IsSequence() || node.size() != 2) {return false;}
    spot = {node[0].as<double>(), node[1].as<double>()};
    return true;
  }
};
}  // namespace YAML

template<class F>
void tried(F && f)
{
  try {
    f();
    std::cout << "nothing" << std::endl;
  } catch (const YAML::Exception & error) {
    std::cout << error.what() << std::endl;
  }
}
static void reads()
{
  YAML::Node config = YAML::LoadFile("robot.yaml");
  const YAML::Node fixed = config;
  std::cout << config["name"].as<std::string>() << config["wheels"].size() << config["speed"].as<float>() << config["on"].as<bool>()
            << config["code"].as<int>() << config["none"].IsNull() << fixed["no"].IsDefined() << bool(fixed["no"])
            << fixed["no"].as<int>(7) << config["name"].Mark().line << std::endl;
  for (const auto & wheel : config["wheels"]) {std::cout << wheel["side"].as<std::string>() << wheel["radius"].as<double>() << " ";}
  for (auto it = config["limits"].begin(); it != config["limits"].end(); ++it) {
    std::cout << it->first.as<std::string>() << "=" << it->second.as<double>() << " ";
  }
  auto gains = config["gains"].as<std::vector<double>>();
  auto limits = config["limits"].as<std::map<std::string, double>>();
  auto spots = config["spots"].as<std::vector<Spot>>();
  std::cout << gains.size() << limits.at("low") << spots.at(1).y << config["same"]["low"].as<int>() << std::endl;
  tried([&] {config["name"].as<int>();});
  tried([&] {fixed["no"]["deeper"].as<int>();});
  tried([&] {config["name"]["x"] = 1;});
  tried([&] {config["gains"].as<std::map<std::string, int>>();});
  tried([] {YAML::LoadFile("/no/such/file.yaml");});
  tried([] {YAML::Load("a: [1, 2");});
  std::cout << YAML::LoadAll("1\n---\n2\n").size() << YAML::Load("").IsNull() << YAML::Load("'5'").Tag() << YAML::Load("!odd 5").Tag()
            << YAML::Load(".inf").as<double>() << YAML::Load("-3").as<unsigned>(9) << YAML::Load("0x1F").as<int>() << std::endl;
}
static void writes()
{
  YAML::Node node;
  node["name"] = "robot: one";
  node["pose"]["x"] = 1.5;
  node["pose"]["up"] = true;
  node["list"].push_back(1);
  node["list"].push_back("two");
  node["spot"] = Spot{1, 2};
  node["asked"];
  YAML::Node alias = node["pose"];
  alias["x"] = 2;
  node.remove("spot");
  node["list"].remove(0);
  node["list"][0] = 1;
  node["list"][1] = "two";
  std::cout << node << "\n" << node.size() << node["pose"]["x"].as<int>() << node.IsMap() << YAML::Clone(node)["list"][1] << std::endl;
  YAML::Emitter out;
  out << YAML::BeginMap << YAML::Key << "waypoints" << YAML::Value << YAML::BeginSeq;
  for (double x : {0.5, 1.25}) {
    out << YAML::BeginMap << YAML::Key << "x" << YAML::Value << x << YAML::Key << "on" << YAML::Value << true << YAML::EndMap;
  }
  out << YAML::EndSeq << YAML::Key << "gains" << YAML::Value << YAML::Flow << std::vector<int>{1, 2, 3};
  out << YAML::Key << "none" << YAML::Value << YAML::Null << YAML::Key << "text" << YAML::DoubleQuoted << "5" << YAML::EndMap;
  std::cout << out.c_str() << "\n" << out.good() << std::endl;
  std::ofstream("written.yaml") << out.c_str();
  std::cout << YAML::LoadFile("written.yaml")["waypoints"][1]["x"].as<double>() << YAML::Dump(YAML::Load("[a, {b: c}]")) << std::endl;
}
static void comments()
{
  YAML::Emitter out, only;
  out << YAML::Comment("what a robot may do") << YAML::BeginMap << YAML::Key << "speed" << YAML::Value << 0.5 << YAML::Comment("m/s");
  out << YAML::Key << "spot" << YAML::Value << YAML::Flow << YAML::BeginSeq << 1 << 2 << YAML::EndSeq << YAML::Comment("in m");
  out << YAML::Key << "wheels" << YAML::Value << YAML::BeginSeq << YAML::Comment("left first");
  out << "one" << "two" << YAML::Comment("of two\nlines") << YAML::EndSeq << YAML::EndMap;
  only << YAML::Comment("nothing");
  std::cout << out.c_str() << "\n" << only.c_str() << std::endl;
}
int main()
{
  reads();
  writes();
  comments();
}
