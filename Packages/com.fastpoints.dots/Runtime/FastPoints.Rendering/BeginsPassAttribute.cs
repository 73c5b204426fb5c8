using System;

namespace FastPoints.Rendering
{
    /// <summary>Marks a static method without parameters that begins to draw clouds in a pipeline; calling it again changes
    /// nothing. The editor calls it after loading scripts, and <c>End</c> beside it before they are reloaded. In players it is
    /// called through an attribute of Unity's that edit mode ignores.</summary>
    [AttributeUsage(AttributeTargets.Method)]
    internal sealed class BeginsPassAttribute : Attribute { }
}
