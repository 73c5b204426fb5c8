using System;

namespace FastPoints.Base
{
    /// <summary>A struct that is written to disk as it lies in memory: its byte table stands in
    /// <c>Documentation~/disk-format.md</c>, and a check holds the two together.</summary>
    [AttributeUsage(AttributeTargets.Struct)]
    internal sealed class DiskFormatAttribute : Attribute
    {
    }
}
