using System;

namespace FastPoints.Base
{
    /// <summary>A struct that shaders read from a buffer as it lies in memory: its HLSL twin is written to
    /// <c>Shaders/Generated</c>, and a check holds the two together.</summary>
    [AttributeUsage(AttributeTargets.Struct)]
    internal sealed class GenerateHlslAttribute : Attribute
    {
    }
}
