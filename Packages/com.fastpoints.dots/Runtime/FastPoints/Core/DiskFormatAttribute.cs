using System;

namespace FastPoints.Core
{
    // Marks a struct that lies on disk as in memory: a check keeps it equal to its table in Documentation~/disk-format.md.
    [AttributeUsage(AttributeTargets.Struct)]
    internal sealed class DiskFormatAttribute : Attribute { }
}
