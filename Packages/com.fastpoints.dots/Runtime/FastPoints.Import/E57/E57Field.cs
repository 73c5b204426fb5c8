using Unity.Mathematics;

namespace FastPoints.E57
{
    sealed class E57Field
    {
        public string Name; // Fields within structures have the structures' names before theirs: "a/b".

        public E57FieldKind Kind;
        public int Stream;
        public long Minimum;
        public long Maximum;

        // NaN if the file does not say.
        public double FloatMinimum;
        public double FloatMaximum;

        public bool IsScaled;

        // Value = integer * Scale + Offset; 1 and 0 for plain integers and floats.
        public double Scale = 1;
        public double Offset;
        public int Bits; // 0 for a field with the same value in all points, -1 for strings.

        public bool IsInteger => Kind == E57FieldKind.Integer;
        public double MinReal => IsInteger ? math.min(Minimum * Scale, Maximum * Scale) + Offset : FloatMinimum;
        public double MaxReal => IsInteger ? math.max(Minimum * Scale, Maximum * Scale) + Offset : FloatMaximum;

        // Null if it cannot be read, for which "problem" gives the reason.
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
            // Limits of floats are only displayed; unreadable ones are ignored.
            if (!E57Text.TryReal(node.Attribute("minimum"), double.NaN, out FloatMinimum))
                FloatMinimum = double.NaN;
            if (!E57Text.TryReal(node.Attribute("maximum"), double.NaN, out FloatMaximum))
                FloatMaximum = double.NaN;
            return null;
        }

        static string Unreadable(E57Node node, string attribute) =>
            attribute + ": got \"" + E57Text.OneLine(node.Attribute(attribute)) + "\"";

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

    enum E57FieldKind
    {
        // Bit-packed differences from a minimum.
        Integer,
        Float32,
        Float64,

        String,
    }

    struct E57FieldRead
    {
        public E57FieldKind Kind;
        public int Stream; // -1 for a value that no stream holds.

        public int Bits;

        // For integers: what the packed differences are added to, and the largest difference.
        public long Minimum;
        public ulong Range;

        public E57Target Target;
        public AttributeType ColumnType;
        public int ColumnOffsetBytes;
        public int Row; // For vectors: 0 to 2 for positions, 3 to 5 for normals.

        // For columns of integers: stored * Factor + Shift.
        public long Factor;
        public long Shift;
        public double Scale;
        public double Offset;
    }

    enum E57Target
    {
        Integers, // A column of an integer type: integer * factor + shift.

        To16Bits, // A column of an integer type: round(value * scale + offset), clamped to 0 to 65,535.

        Reals, // A column of floats or doubles: value * scale + offset.

        Vector, // One of the three (or six) rows of doubles that become positions and normals.

        InvalidFlag, // None: points whose value is not 0 are left out.
    }
}
