namespace UnityEngine.Serialization
{
    [AttributeUsage(AttributeTargets.Field, AllowMultiple = true, Inherited = false)]
    public partial class FormerlySerializedAsAttribute(string oldName) : Attribute
    {
        internal readonly string OldName = oldName;
    }
}

namespace UnityEngine
{
    [AttributeUsage(AttributeTargets.Field)]
    public sealed class SerializeField : Attribute { }

    [AttributeUsage(AttributeTargets.Field)]
    public sealed class HideInInspector : Attribute { }

    [AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
    public abstract class PropertyAttribute : Attribute { }

    [AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
    public sealed class RangeAttribute(float min, float max) : PropertyAttribute
    {
        public readonly float min = min;
        public readonly float max = max;
    }

    [AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
    public sealed class MinAttribute(float min) : PropertyAttribute
    {
        public readonly float min = min;
    }

    [AttributeUsage(AttributeTargets.Class)]
    public class HelpURLAttribute(string url) : Attribute
    {
        public virtual string URL => url;
    }

    /// <summary>In the project or a package: a texture.</summary>
    [AttributeUsage(AttributeTargets.Class)]
    public class IconAttribute(string path) : Attribute
    {
        public string path { get; } = path;
    }

    [AttributeUsage(AttributeTargets.Field, Inherited = true, AllowMultiple = false)]
    public class TooltipAttribute(string tooltip) : PropertyAttribute
    {
        public readonly string tooltip = tooltip;
    }
}
