namespace UnityEngine;

/// <summary>Columns one after the other in memory, for column vectors: m12 is row 1, column 2.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe partial struct Matrix4x4 : IEquatable<Matrix4x4>, IFormattable
{
    public float m00;
    public float m10;
    public float m20;
    public float m30;
    public float m01;
    public float m11;
    public float m21;
    public float m31;
    public float m02;
    public float m12;
    public float m22;
    public float m32;
    public float m03;
    public float m13;
    public float m23;
    public float m33;

    public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
    {
        this = default;
        SetColumn(0, column0);
        SetColumn(1, column1);
        SetColumn(2, column2);
        SetColumn(3, column3);
    }

    public static Matrix4x4 zero => default;
    public static Matrix4x4 identity => Scale(Vector3.one);
    public Matrix4x4 inverse => Inverse(this);

    public float this[int row, int column]
    {
        get => this[row + column * 4];
        set => this[row + column * 4] = value;
    }

    public float this[int index]
    {
        get => SystemUnsafe.Add(ref m00, CheckIndex(index));
        set => SystemUnsafe.Add(ref m00, CheckIndex(index)) = value;
    }

    public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs) => new Matrix4x4(
        lhs * rhs.GetColumn(0), lhs * rhs.GetColumn(1), lhs * rhs.GetColumn(2), lhs * rhs.GetColumn(3));

    public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector) => lhs.GetColumn(0) * vector.x
        + lhs.GetColumn(1) * vector.y + lhs.GetColumn(2) * vector.z + lhs.GetColumn(3) * vector.w;

    public static bool operator ==(Matrix4x4 lhs, Matrix4x4 rhs) => lhs.GetColumn(0) == rhs.GetColumn(0)
        && lhs.GetColumn(1) == rhs.GetColumn(1) && lhs.GetColumn(2) == rhs.GetColumn(2)
            && lhs.GetColumn(3) == rhs.GetColumn(3);

    public static bool operator !=(Matrix4x4 lhs, Matrix4x4 rhs) => !(lhs == rhs);
    public static Matrix4x4 Scale(Vector3 vector) => new Matrix4x4 { m00 = vector.x, m11 = vector.y, m22 = vector.z, m33 = 1 };

    public static Matrix4x4 Translate(Vector3 vector)
    {
        Matrix4x4 m = identity;
        m.SetColumn(3, new Vector4(vector.x, vector.y, vector.z, 1));
        return m;
    }

    public readonly Vector4 GetColumn(int index)
    {
        Matrix4x4 m = this;
        int first = index * 4;
        return new Vector4(m[first], m[first + 1], m[first + 2], m[first + 3]);
    }

    public readonly Vector4 GetRow(int index)
    {
        Matrix4x4 m = this;
        return new Vector4(m[index], m[index + 4], m[index + 8], m[index + 12]);
    }

    public void SetColumn(int index, Vector4 column)
    {
        for (int row = 0; row < 4; row++)
            this[row, index] = column[row];
    }

    public void SetRow(int index, Vector4 row)
    {
        for (int column = 0; column < 4; column++)
            this[index, column] = row[column];
    }

    public readonly Vector3 MultiplyPoint3x4(Vector3 point) => this * new Vector4(point.x, point.y, point.z, 1);

    public readonly bool Equals(Matrix4x4 other) => GetColumn(0).Equals(other.GetColumn(0))
        && GetColumn(1).Equals(other.GetColumn(1)) && GetColumn(2).Equals(other.GetColumn(2))
        && GetColumn(3).Equals(other.GetColumn(3));

    public override readonly bool Equals(object other) => other is Matrix4x4 matrix && Equals(matrix);
    public override readonly int GetHashCode() => HashCode.Combine(GetColumn(0), GetColumn(1), GetColumn(2), GetColumn(3));
    public override readonly string ToString() => ToString("F5", null);

    public readonly string ToString(string format, IFormatProvider formatProvider)
    {
        formatProvider ??= CultureInfo.InvariantCulture;
        var lines = new string[4];
        for (int row = 0; row < 4; row++)
        {
            Vector4 v = GetRow(row);
            lines[row] = string.Join("\t", v.x.ToString(format, formatProvider), v.y.ToString(format, formatProvider),
                v.z.ToString(format, formatProvider), v.w.ToString(format, formatProvider));
        }
        return string.Join("\n", lines) + "\n";
    }

    static int CheckIndex(int index) =>
        (uint)index < 16 ? index : throw new IndexOutOfRangeException("Invalid matrix index!");
}
