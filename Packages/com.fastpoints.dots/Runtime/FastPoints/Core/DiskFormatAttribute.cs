using System;

namespace FastPoints.Core
{
    /// <summary>Marks a struct that is written to disk as it lies in memory. Its byte table is in
    /// <c>Documentation~/disk-format.md</c>, and a check keeps both equal.</summary>
    [AttributeUsage(AttributeTargets.Struct)]
    internal sealed class DiskFormatAttribute : Attribute { }
}
