namespace Unity.PerformanceTesting;

public enum SampleUnit
{
    Nanosecond,
    Microsecond,
    Millisecond,
    Second,
    Byte,
    Kilobyte,
    Megabyte,
    Gigabyte,
    Undefined,
}
