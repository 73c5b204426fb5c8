uint Scaled(uint number)
{
#if defined(TWICE)
    return number * 2u;
#else
    return number;
#endif
}
