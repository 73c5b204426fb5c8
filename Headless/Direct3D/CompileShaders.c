/* Compiles many shaders by Direct3D's compiler, in one process: under Wine a start takes seconds.

   CompileShaders.exe COMPILER LIST RESULTS
     COMPILER   the DLL, by its full path
     LIST       a line for each: file, entry point, profile, flags of D3DCompile in hex; one tab between
     RESULTS    for each "> ok" or "> failed", and below it what the compiler said */
#define COBJMACROS
#include <windows.h>
#include <d3dcompiler.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int fail(const char *what, const char *name)
{
    fprintf(stderr, "%s: %s\n", name, what);
    return 2;
}

static char *read_all(const char *name, size_t *length)
{
    FILE *file = fopen(name, "rb");
    char *text;
    if (!file)
        return NULL;
    fseek(file, 0, SEEK_END);
    *length = (size_t)ftell(file);
    rewind(file);
    text = malloc(*length + 1);
    *length = fread(text, 1, *length, file);
    fclose(file);
    return text;
}

int main(int count, char **arguments)
{
    char line[1024], file[256], entry[256], profile[32];
    unsigned flags;
    HMODULE library;
    pD3DCompile compile;
    FILE *list, *results;

    if (count != 4)
        return fail("COMPILER LIST RESULTS are wanted", arguments[0]);
    library = LoadLibraryA(arguments[1]);
    compile = library ? (pD3DCompile)(void *)GetProcAddress(library, "D3DCompile") : NULL;
    list = fopen(arguments[2], "r");
    results = fopen(arguments[3], "wb");
    if (!compile || !list || !results)
        return fail("cannot be opened", arguments[!compile ? 1 : !list ? 2 : 3]);
    while (fgets(line, sizeof line, list))
    {
        ID3DBlob *code = NULL, *said = NULL;
        size_t length;
        char *text;
        HRESULT result;
        if (sscanf(line, "%255[^\t]\t%255[^\t]\t%31[^\t]\t%x", file, entry, profile, &flags) != 4)
            return fail("not a line of four fields", line);
        text = read_all(file, &length);
        if (!text)
            return fail("cannot be read", file);
        result = compile(text, length, file, NULL, NULL, entry, profile, flags, 0, &code, &said);
        fprintf(results, "> %s\n", SUCCEEDED(result) ? "ok" : "failed");
        if (said)
        {
            fprintf(results, "%s\n", (const char *)ID3D10Blob_GetBufferPointer(said));
            ID3D10Blob_Release(said);
        }
        if (code)
            ID3D10Blob_Release(code);
        free(text);
    }
    fclose(results);
    return 0;
}
