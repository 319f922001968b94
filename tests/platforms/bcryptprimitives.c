/* Stands in for Windows' bcryptprimitives.dll where wine has none (before 9.0): Rust's standard library asks it for
   the random keys of its hash maps. For the test under wine alone. */
__declspec(dllexport) int ProcessPrng(unsigned char *bytes, unsigned long long count)
{
    for (unsigned long long i = 0; i < count; i++)
        bytes[i] = (unsigned char)(37 * i + 11);
    return 1;
}
