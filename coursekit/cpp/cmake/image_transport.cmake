# Programs load the transports of images that packages describe.
target_link_libraries(image_transport::image_transport INTERFACE pluginlib::pluginlib)
