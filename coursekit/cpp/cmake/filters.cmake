# Chains load the filters that packages describe.
find_package(pluginlib QUIET)
target_link_libraries(filters::filters INTERFACE pluginlib::pluginlib)
