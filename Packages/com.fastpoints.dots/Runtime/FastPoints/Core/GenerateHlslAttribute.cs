using System;

namespace FastPoints.Core
{
    /// <summary>Marks a struct that shaders read from a buffer as it lies in memory. Its HLSL twin is written to
    /// <c>Shaders/Generated</c>, and a check keeps both equal.</summary>
    [AttributeUsage(AttributeTargets.Struct)]
    internal sealed class GenerateHlslAttribute : Attribute { }
}
