/* require "talus" in a program that has a Lua of its own, also the C build (Debian's lua5.4). The engine comes in a shared
   object with the C++ build of Lua, whose functions have the same names: RTLD_DEEPBIND lets each find its own. Here Lua is
   the host's; its errors, longjmps, never meet a frame of the engine, and the engine's exceptions end in api.cpp. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "module/api.h"

static struct {
  talus_outcome* (*run)(const talus_job*);
  int (*status)(const talus_outcome*);
  const char* (*message)(const talus_outcome*);
  long (*simulations)(const talus_outcome*);
  const char* (*report)(const talus_outcome*, long);
  const char* (*folder)(const talus_outcome*, long);
  void (*free)(talus_outcome*);
  int (*main)(int, const char* const*);
  int (*interrupted)(void);
  const char* (*library)(void);
  const char* (*version)(void);
} engine;

/* The engine's object lies in a folder of this one's name: talus.so, talus/engine.so. It stays loaded: it has threads. */
static void load_engine(lua_State* L) {
  static void* object = NULL;
  Dl_info own;
  if (object) return;
  if (!dladdr((void*)load_engine, &own)) luaL_error(L, "talus: the module does not know where it lies");
  lua_pushstring(L, own.dli_fname);
  const char* path = luaL_gsub(L, lua_tostring(L, -1), ".so", "/engine.so");
  void* opened = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND | RTLD_NODELETE);
  if (!opened) luaL_error(L, "talus: %s", dlerror());
  const struct {
    const char* name;
    void* place;
  } entries[] = {{"talus_run", &engine.run},         {"talus_status", &engine.status},
                 {"talus_message", &engine.message}, {"talus_simulations", &engine.simulations},
                 {"talus_report", &engine.report},   {"talus_folder", &engine.folder},
                 {"talus_free", &engine.free},       {"talus_main", &engine.main},
                 {"talus_library", &engine.library}, {"talus_interrupted", &engine.interrupted},
                 {"talus_version_text", &engine.version}};
  for (size_t i = 0; i < sizeof entries / sizeof *entries; ++i) {
    void* found = dlsym(opened, entries[i].name);
    if (!found) luaL_error(L, "talus: %s has no %s: it is of another Talus", path, entries[i].name);
    memcpy(entries[i].place, &found, sizeof found);
  }
  object = opened;
  lua_pop(L, 2);
}

/* A run as the host sees it: `handler` and `error` are places on its stack. */
typedef struct {
  lua_State* L;
  int handler, error;
  const talus_step* step;
} call_of_step;

static void set_integer(lua_State* L, const char* name, long value) {
  lua_pushinteger(L, value);
  lua_setfield(L, -2, name);
}

static void set_number(lua_State* L, const char* name, double value) {
  lua_pushnumber(L, value);
  lua_setfield(L, -2, name);
}

/* handler(step), in protected mode; argument: call_of_step; result: what it returns. */
static int give_step(lua_State* L) {
  const call_of_step* call = lua_touserdata(L, 1);
  const talus_step* step = call->step;
  luaL_checkstack(L, 8, "on_step");
  lua_pushvalue(L, 2);
  lua_createtable(L, 0, 8);
  set_integer(L, "simulation", step->simulation);
  set_integer(L, "number", step->number);
  set_number(L, "time", step->time);
  set_number(L, "dt", step->dt);
  set_number(L, "displacement", step->displacement);
  set_integer(L, "iterations", step->iterations);
  set_integer(L, "contacts", step->contacts);
  set_integer(L, "failures", step->failures);
  lua_call(L, 1, 1);
  return 1;
}

/* Ctrl-C during the host's function: the engine's handler has noted it, the function is left here. */
static void leave_if_interrupted(lua_State* L, lua_Debug* unused) {
  (void)unused;
  if (engine.interrupted()) luaL_error(L, "interrupted");
}

static talus_wish on_step(void* host, const talus_step* step, char* message, unsigned long size) {
  call_of_step* call = host;
  lua_State* L = call->L;
  const int watched = lua_gethook(L) == NULL; /* a hook of the host's own is left alone */
  if (!lua_checkstack(L, 4)) return snprintf(message, size, "on_step: the stack is full"), talus_fail;
  call->step = step;
  lua_pushcfunction(L, give_step);
  lua_pushlightuserdata(L, call);
  lua_pushvalue(L, call->handler);
  if (watched) lua_sethook(L, leave_if_interrupted, LUA_MASKCOUNT, 1000);
  const int failed = lua_pcall(L, 2, 1, 0) != LUA_OK;
  if (watched) lua_sethook(L, NULL, 0, 0);
  if (!failed) {
    const int stop = lua_isboolean(L, -1) && !lua_toboolean(L, -1);
    lua_pop(L, 1);
    return stop ? talus_stop : talus_go_on;
  }
  const char* text = lua_type(L, -1) == LUA_TSTRING ? lua_tostring(L, -1) : "on_step: an error that is no text";
  snprintf(message, size, "%s", text);
  lua_replace(L, call->error); /* raised again, as it is, when the engine has returned */
  return talus_fail;
}

static int free_outcome(lua_State* L) {
  talus_outcome** outcome = lua_touserdata(L, 1);
  if (*outcome) engine.free(*outcome);
  *outcome = NULL;
  return 0;
}

/* What came of it as a list { status, message, { report = …, folder = … }, … }. */
static void push_outcome(lua_State* L, const talus_outcome* outcome) {
  const long count = engine.simulations(outcome);
  lua_createtable(L, (int)count, 2);
  set_integer(L, "status", engine.status(outcome));
  lua_pushstring(L, engine.message(outcome));
  lua_setfield(L, -2, "message");
  for (long i = 0; i < count; ++i) {
    lua_createtable(L, 0, 2);
    lua_pushstring(L, engine.report(outcome, i));
    lua_setfield(L, -2, "report");
    lua_pushstring(L, engine.folder(outcome, i));
    lua_setfield(L, -2, "folder");
    lua_rawseti(L, -2, i + 1);
  }
}

/* The list of texts at `index`, ended by NULL; kept by a userdata on the stack. */
static const char** texts_at(lua_State* L, int index) {
  const lua_Integer count = luaL_len(L, index);
  const char** texts = lua_newuserdatauv(L, (size_t)(count + 1) * sizeof *texts, 0);
  for (lua_Integer i = 0; i < count; ++i) {
    lua_rawgeti(L, index, i + 1);
    texts[i] = luaL_checkstring(L, -1); /* the list keeps it */
    lua_pop(L, 1);
  }
  texts[count] = NULL;
  return texts;
}

/* run(scene, { name, value, … }, output or nil, command line, trust, progress, on_step or nil); lib/talus/host.lua has checked
   them. Gives the list of push_outcome, or raises the error that on_step ended with. */
static int run(lua_State* L) {
  lua_settop(L, 8); /* 8: the error */
  talus_outcome** kept = lua_newuserdatauv(L, sizeof *kept, 0);
  *kept = NULL;
  lua_createtable(L, 0, 1);
  lua_pushcfunction(L, free_outcome);
  lua_setfield(L, -2, "__gc");
  lua_setmetatable(L, -2);
  const char** parameters = texts_at(L, 2);
  call_of_step call = {.L = L, .handler = 7, .error = 8, .step = NULL};
  const talus_job job = {.scene = luaL_checkstring(L, 1),
                         .parameters = parameters,
                         .output = luaL_optstring(L, 3, NULL),
                         .command_line = luaL_checkstring(L, 4),
                         .trust = lua_toboolean(L, 5),
                         .progress = lua_toboolean(L, 6),
                         .host = &call,
                         .on_step = lua_isnil(L, 7) ? NULL : on_step};
  *kept = engine.run(&job);
  if (!*kept) return luaL_error(L, "talus.run: out of memory");
  if (!lua_isnil(L, 8) && !engine.interrupted()) return lua_pushvalue(L, 8), lua_error(L);
  push_outcome(L, *kept);
  return 1;
}

/* main({ argument, … }): the exit status. */
static int run_as_program(lua_State* L) {
  luaL_checktype(L, 1, LUA_TTABLE);
  const int count = (int)luaL_len(L, 1);
  lua_pushinteger(L, engine.main(count, texts_at(L, 1)));
  return 1;
}

/* The rest is Lua, in the host's state: lib/talus/host.lua, a function of these two, the library's folder and the version. */
#pragma GCC visibility push(default)
int luaopen_talus(lua_State* L) {
  load_engine(L);
  const char* file = lua_pushfstring(L, "%s/talus/host.lua", engine.library());
  if (luaL_loadfilex(L, file, "t") != LUA_OK) return lua_error(L);
  lua_pushcfunction(L, run);
  lua_pushcfunction(L, run_as_program);
  lua_pushstring(L, engine.library());
  lua_pushstring(L, engine.version());
  lua_call(L, 4, 1);
  return 1;
}
#pragma GCC visibility pop
