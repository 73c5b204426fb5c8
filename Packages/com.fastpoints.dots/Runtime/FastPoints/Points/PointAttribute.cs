using System;

namespace FastPoints.Points
{
    /// <summary>One component that every point of a cloud has: a name, a type, and how its stored values read.</summary>
    public sealed class PointAttribute : IEquatable<PointAttribute>
    {
        /// <summary>The field's usual name (<see cref="AttributeNames"/>), or the name that the file gives it.</summary>
        public string Name { get; }

        public AttributeType Type { get; }

        /// <summary>Value = stored * <see cref="Scale"/> + <see cref="Offset"/>. 1 and 0 but for scaled extra bytes;
        /// positions keep theirs in the cloud's <see cref="PositionTransform"/>.</summary>
        public double Scale { get; }

        public double Offset { get; }

        public PointAttribute(string name, AttributeType type, double scale = 1, double offset = 0)
        {
            Name = name;
            Type = type;
            Scale = scale;
            Offset = offset;
        }

        public bool Equals(PointAttribute other) =>
            other != null && Name == other.Name && Type == other.Type && Scale.Equals(other.Scale) && Offset.Equals(other.Offset);

        public override bool Equals(object obj) => Equals(obj as PointAttribute);
        public override int GetHashCode() => Name.GetHashCode() * 31 + (int)Type;
        public override string ToString() => Name + ":" + Type;
    }
}
