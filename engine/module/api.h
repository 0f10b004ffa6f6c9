/* What the Lua module (lua_module.c, compiled against a plain C Lua) may ask of the engine: plain C, so that neither an
   exception of the engine nor a longjmp of the host's Lua ever crosses from one to the other. */
#ifndef TALUS_MODULE_API_H
#define TALUS_MODULE_API_H

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {   /* an accepted step; SI units */
  long simulation; /* of those that the scene makes, from 1 */
  long number;     /* of the step, from 1 */
  double time, dt, displacement;
  long iterations, contacts, failures;
} talus_step;

typedef enum { talus_go_on = 0, talus_stop = 1, talus_fail = 2 } talus_wish;

typedef struct {
  const char* scene;
  const char* const* parameters; /* name, value, name, value, …; NULL at the end */
  const char* output;            /* folder of results; NULL: as the scene says */
  const char* command_line;      /* for run.json */
  int trust, progress;
  void* host; /* handed to the following */
  /* May be NULL. For talus_fail it leaves its message in `message`, of `size` bytes. */
  talus_wish (*on_step)(void* host, const talus_step* step, char* message, unsigned long size);
} talus_job;

typedef struct talus_outcome talus_outcome; /* of a job */

/* NULL only where there is no memory for the outcome itself. */
talus_outcome* talus_run(const talus_job* job);
int talus_status(const talus_outcome* outcome);          /* that `talus scene.lua` would exit with */
const char* talus_message(const talus_outcome* outcome); /* what it would have printed, or "" */
long talus_simulations(const talus_outcome* outcome);
const char* talus_report(const talus_outcome* outcome, long i); /* run.json of simulation i, from 0 */
const char* talus_folder(const talus_outcome* outcome, long i); /* where its results are, or "" */
void talus_free(talus_outcome* outcome);

/* `talus scene.lua …` with these arguments (without the program's name); its exit status. Prints what that prints. */
int talus_main(int count, const char* const* arguments);

int talus_interrupted(void);     /* whether SIGINT, SIGTERM or a limit asks the run to end */
const char* talus_library(void); /* folder of the Lua library; "" where it is not found */
const char* talus_version_text(void);

#ifdef __cplusplus
}
#endif
#endif
