"""Images on topics, raw and compressed: viewing and republishing. In ROS 2: image_transport, rqt_image_view."""
