# backward_ros: a program's last steps before a crash, which Python's side tells here; its link has nothing to add.
macro(add_backward)
endmacro()
set(BACKWARD_ENABLE "")
