using FastPoints.Core;
using Unity.Mathematics;

namespace FastPoints.E57
{
    /// <summary>One field of a scan's points: an element of its prototype, and one bytestream of its packets.</summary>
    sealed class E57Field
    {
        /// <summary>The name in the file; fields within structures have the structures' names before theirs: "a/b".</summary>
        public string Name;

        public E57FieldKind Kind;

        /// <summary>Its index among the bytestreams.</summary>
        public int Stream;

        /// <summary>For integers: the smallest and the largest that the file declares.</summary>
        public long Minimum;
        public long Maximum;

        /// <summary>For floats: the same; NaN if the file does not say.</summary>
        public double FloatMinimum;
        public double FloatMaximum;

        public bool IsScaled;

        /// <summary>Value = integer * <see cref="Scale"/> + <see cref="Offset"/>; 1 and 0 for plain integers and
        /// floats.</summary>
        public double Scale = 1;
        public double Offset;

        /// <summary>Bits of one value; 0 for a field with the same value in all points, -1 for strings.</summary>
        public int Bits;

        public bool IsInteger => Kind == E57FieldKind.Integer;

        /// <summary>The smallest value as a real number.</summary>
        public double MinReal => IsInteger ? math.min(Minimum * Scale, Maximum * Scale) + Offset : FloatMinimum;

        /// <summary>The largest value as a real number.</summary>
        public double MaxReal => IsInteger ? math.max(Minimum * Scale, Maximum * Scale) + Offset : FloatMaximum;

        /// <param name="problem">What is wrong with it, if it cannot be read.</param>
        /// <returns>The field, or null.</returns>
        public static E57Field Read(E57Node node, string name, int stream, out string problem)
        {
            var field = new E57Field { Name = name, Stream = stream };
            problem = null;
            switch (node.Type)
            {
                case "Integer":
                case "ScaledInteger":
                    problem = field.ReadInteger(node);
                    break;
                case "Float":
                    problem = field.ReadFloat(node);
                    break;
                case "String":
                    field.Kind = E57FieldKind.String;
                    field.Bits = -1;
                    break;
                default:
                    problem = "type: wanted Integer, ScaledInteger, Float or String, got \"" +
                        E57Text.OneLine(node.Type ?? "") + "\"";
                    break;
            }
            if (problem == null)
                return field;
            problem = "field " + name + ": " + problem;
            return null;
        }

        string ReadInteger(E57Node node)
        {
            Kind = E57FieldKind.Integer;
            IsScaled = node.Type == "ScaledInteger";
            if (!E57Text.TryInteger(node.Attribute("minimum"), long.MinValue, out Minimum))
                return Unreadable(node, "minimum");
            if (!E57Text.TryInteger(node.Attribute("maximum"), long.MaxValue, out Maximum))
                return Unreadable(node, "maximum");
            if (Minimum > Maximum)
                return "its minimum " + NumberText.Of(Minimum) + " is above its maximum " + NumberText.Of(Maximum);
            Bits = 64 - math.lzcnt((ulong)Maximum - (ulong)Minimum);
            if (!IsScaled)
                return null;
            if (!E57Text.TryReal(node.Attribute("scale"), 1, out Scale))
                return Unreadable(node, "scale");
            if (!E57Text.TryReal(node.Attribute("offset"), 0, out Offset))
                return Unreadable(node, "offset");
            return !math.isfinite(Scale) || !math.isfinite(Offset)
                ? "scale " + NumberText.Of(Scale) + " and offset " + NumberText.Of(Offset) + " must be finite"
                : Scale == 0 ? "its scale is 0" : null;
        }

        string ReadFloat(E57Node node)
        {
            string precision = node.Attribute("precision");
            if (precision != null && precision != "single" && precision != "double")
                return Unreadable(node, "precision");
            Kind = precision == "single" ? E57FieldKind.Float32 : E57FieldKind.Float64;
            Bits = precision == "single" ? 32 : 64;
            // Limits of floats are for people; unreadable ones are ignored.
            if (!E57Text.TryReal(node.Attribute("minimum"), double.NaN, out FloatMinimum))
                FloatMinimum = double.NaN;
            if (!E57Text.TryReal(node.Attribute("maximum"), double.NaN, out FloatMaximum))
                FloatMaximum = double.NaN;
            return null;
        }

        static string Unreadable(E57Node node, string attribute) =>
            attribute + ": got \"" + E57Text.OneLine(node.Attribute(attribute)) + "\"";

        /// <summary>Describes type and range for people.</summary>
        public string Summary()
        {
            switch (Kind)
            {
                case E57FieldKind.String:
                    return "String (left out)";
                case E57FieldKind.Float32:
                case E57FieldKind.Float64:
                    string type = Kind == E57FieldKind.Float32 ? "Float single" : "Float double";
                    return math.isfinite(FloatMinimum) && math.isfinite(FloatMaximum) && FloatMaximum < float.MaxValue
                        ? type + ", " + NumberText.Of(FloatMinimum) + " to " + NumberText.Of(FloatMaximum)
                        : type;
                default:
                    string range = (IsScaled ? "ScaledInteger, " : "Integer, ") + NumberText.Of(Minimum) + " to " +
                        NumberText.Of(Maximum) + ", " + Bits + " bits";
                    return IsScaled ? range + ", scale " + NumberText.Of(Scale) + ", offset " + NumberText.Of(Offset) : range;
            }
        }
    }

    /// <summary>The layout of a field's values in its bytestream.</summary>
    enum E57FieldKind
    {
        /// <summary>Bit-packed differences from a minimum.</summary>
        Integer,
        Float32,
        Float64,

        /// <summary>Strings of any length, which are not read.</summary>
        String,
    }

    /// <summary>How one field of one scan is decoded. Blittable, for jobs.</summary>
    struct E57FieldRead
    {
        public E57FieldKind Kind;

        /// <summary>Its index among the bytestreams; -1 for a value that no stream holds.</summary>
        public int Stream;

        /// <summary>Bits of one value; 0 for one that is the same in all points.</summary>
        public int Bits;

        /// <summary>For integers: what the packed differences are added to, and the largest difference.</summary>
        public long Minimum;
        public ulong Range;

        public E57Target Target;

        /// <summary>For columns: the type of their values and where the column starts.</summary>
        public AttributeType ColumnType;
        public int ColumnOffsetBytes;

        /// <summary>For vectors: 0 to 2 for positions, 3 to 5 for normals.</summary>
        public int Row;

        /// <summary>For columns of integers: stored * Steps + Bias.</summary>
        public long Steps;
        public long Bias;
        public double Factor;
        public double Addend;
    }

    /// <summary>The destination of a field's values.</summary>
    enum E57Target
    {
        /// <summary>A column of an integer type: integer * steps + bias.</summary>
        Integers,

        /// <summary>A column of an integer type: round(value * factor + addend), clamped to 0 to 65,535.</summary>
        Shares,

        /// <summary>A column of floats or doubles: value * factor + addend.</summary>
        Reals,

        /// <summary>One of the three (or six) rows of doubles that become positions and normals: computed the same way.</summary>
        Vector,

        /// <summary>None: points whose value is not 0 are left out.</summary>
        Invalid,
    }
}
