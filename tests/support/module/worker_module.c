/* SPDX-License-Identifier: MIT */
/* A module of the worker for api.io_module. The first byte of the request chooses what it does. */
#include <shd/worker.h>

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

SHD_API shd_result shd_worker_entry(const shd_worker_call *call);

/* Sends the file whose name follows the first byte of the request. */
static shd_result echo(const shd_worker_call *call, const char *name)
{
    const void *bytes = NULL;
    size_t size = 0;
    const shd_result result = call->find(name, &bytes, &size);
    if (result != SHD_OK) {
        snprintf(call->message, call->message_size, "no file \"%s\"", name);
        return result;
    }
    call->send(bytes, size);
    return SHD_OK;
}

static shd_result ask_forever(const shd_worker_call *call)
{
    const void *bytes = NULL;
    size_t size = 0;
    while (call->find("missing", &bytes, &size) == SHD_ERROR_NOT_FOUND) continue;
    return SHD_OK;
}

shd_result shd_worker_entry(const shd_worker_call *call)
{
    static int runs;
    const char *request = call->request;
    switch (request[0]) {
        case 'e': return echo(call, request + 1);
        case 'c':
            signal(SIGSEGV, SIG_DFL); /* a sanitizer has a handler */
            raise(SIGSEGV);
            return SHD_OK;
        case 'x': _exit(0);
        case 'h':
            while (pause() < 0) continue;
            return SHD_OK;
        case 'q': return ask_forever(call);
        case 'm': return malloc((size_t)1 << 30) ? SHD_OK : SHD_ERROR_OUT_OF_MEMORY;
        case 'n':
            ++runs;
            call->send(&runs, sizeof runs);
            return SHD_OK;
        case 'p': {
            static pid_t server;
            server = getppid();
            call->send(&server, sizeof server);
            return SHD_OK;
        }
        default: snprintf(call->message, call->message_size, "request %c", request[0]); return SHD_ERROR_UNSUPPORTED;
    }
}
