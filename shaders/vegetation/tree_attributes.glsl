// An instance as vertex attributes (vegetation/instance.glsl).
layout(location = 3) in vec4 treeFoot;
layout(location = 4) in vec4 treeForm;
layout(location = 5) in vec4 treeSun;
layout(location = 6) in vec4 treeAbove;
layout(location = 7) in vec4 treeBelow;
layout(location = 8) in vec4 treeAir;
layout(location = 9) in vec4 treeBend;
