using System;

namespace FastPoints.Core
{
    // Marks a struct that shaders read as it lies in memory: a check keeps it equal to its twin in Shaders/Generated.
    [AttributeUsage(AttributeTargets.Struct)]
    internal sealed class GenerateHlslAttribute : Attribute { }
}
