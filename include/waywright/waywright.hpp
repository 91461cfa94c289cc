#pragma once

#include "waywright/error.hpp"
#include "waywright/id.hpp"
#include "waywright/item.hpp"
#include "waywright/mesh_snapshot.hpp"
#include "waywright/path.hpp"
#include "waywright/path_search.hpp"
#include "waywright/point.hpp"
#include "waywright/query_context.hpp"
#include "waywright/scene.hpp"
#include "waywright/script.hpp"
#include "waywright/svg.hpp"
#include "waywright/world.hpp"
