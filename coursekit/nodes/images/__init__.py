"""Images on topics: raw and compressed, watched and passed on. In ROS 2: image_transport, rqt_image_view."""
