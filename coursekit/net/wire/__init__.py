"""The format of rmw_zenoh: keys, liveliness tokens, QoS texts, attachments. The gateway's file includes this folder."""
