using System;

namespace FastPoints.Rendering
{
    /// <summary>On a static method without parameters that begins to draw clouds in a pipeline; calling it again changes nothing.
    /// The editor calls it when it has loaded scripts; players do by an attribute of Unity's, which edit mode does not look
    /// at.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class BeginsPassAttribute : Attribute
    {
    }
}
