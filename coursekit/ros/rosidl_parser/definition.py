"""The types in a message's SLOT_TYPES, and what IDL files say; see coursekit.interfaces.definition and idl_content."""

from coursekit.interfaces.definition import *  # noqa: F403
from coursekit.interfaces.idl_content import Action as Action
from coursekit.interfaces.idl_content import Annotatable as Annotatable
from coursekit.interfaces.idl_content import Annotation as Annotation
from coursekit.interfaces.idl_content import Constant as Constant
from coursekit.interfaces.idl_content import IdlContent as IdlContent
from coursekit.interfaces.idl_content import IdlFile as IdlFile
from coursekit.interfaces.idl_content import IdlLocator as IdlLocator
from coursekit.interfaces.idl_content import Include as Include
from coursekit.interfaces.idl_content import Member as Member
from coursekit.interfaces.idl_content import Message as Message
from coursekit.interfaces.idl_content import Service as Service
from coursekit.interfaces.idl_content import Structure as Structure
