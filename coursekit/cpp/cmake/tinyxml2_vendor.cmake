# tinyxml2 is the system's; its vendor's package has the module that finds it under the name TinyXML2.
list(APPEND CMAKE_MODULE_PATH "${COURSEKIT_CMAKE}/modules")
