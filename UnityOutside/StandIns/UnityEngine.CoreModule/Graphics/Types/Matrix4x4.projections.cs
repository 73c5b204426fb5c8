namespace UnityEngine;

public unsafe partial struct Matrix4x4
{
    /// <summary>OpenGL's: looks along -Z, depth from -1 to 1. GL.GetGPUProjectionMatrix makes of it what the device
    /// takes.</summary>
    /// <param name="fov">Vertical, in degrees.</param>
    public static Matrix4x4 Perspective(float fov, float aspect, float zNear, float zFar)
    {
        float cotangent = 1 / MathF.Tan(fov * MathF.PI / 360);
        return new Matrix4x4
        {
            m00 = cotangent / aspect,
            m11 = cotangent,
            m22 = (zFar + zNear) / (zNear - zFar),
            m23 = 2 * zFar * zNear / (zNear - zFar),
            m32 = -1,
        };
    }

    public static Matrix4x4 Ortho(float left, float right, float bottom, float top, float zNear, float zFar) => new Matrix4x4
    {
        m00 = 2 / (right - left),
        m03 = -(right + left) / (right - left),
        m11 = 2 / (top - bottom),
        m13 = -(top + bottom) / (top - bottom),
        m22 = -2 / (zFar - zNear),
        m23 = -(zFar + zNear) / (zFar - zNear),
        m33 = 1,
    };

    /// <summary>By Gauss and Jordan, the largest pivot first, in double; zero where there is no inverse, as in Unity.</summary>
    public static Matrix4x4 Inverse(Matrix4x4 m)
    {
        double* rows = stackalloc double[32];
        for (int row = 0; row < 4; row++)
            for (int column = 0; column < 8; column++)
                rows[row * 8 + column] = column < 4 ? m[row, column] : column - 4 == row ? 1 : 0;
        for (int at = 0; at < 4; at++)
        {
            int pivot = at;
            for (int row = at + 1; row < 4; row++)
                if (Math.Abs(rows[row * 8 + at]) > Math.Abs(rows[pivot * 8 + at]))
                    pivot = row;
            double value = rows[pivot * 8 + at];
            if (value == 0)
                return zero;
            for (int column = 0; column < 8; column++)
            {
                double swapped = rows[pivot * 8 + column];
                rows[pivot * 8 + column] = rows[at * 8 + column];
                rows[at * 8 + column] = swapped / value;
            }
            for (int row = 0; row < 4; row++)
            {
                double factor = row == at ? 0 : rows[row * 8 + at];
                for (int column = 0; column < 8; column++)
                    rows[row * 8 + column] -= factor * rows[at * 8 + column];
            }
        }
        Matrix4x4 inverse = default;
        for (int row = 0; row < 4; row++)
            for (int column = 0; column < 4; column++)
                inverse[row, column] = (float)rows[row * 8 + column + 4];
        return inverse;
    }
}
