# Chains load the filters that packages describe.
target_link_libraries(filters::filters INTERFACE pluginlib::pluginlib)
