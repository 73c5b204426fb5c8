using FastPoints.Drawing;
using FastPoints.Store;
using Unity.Mathematics;

namespace FastPoints.Picture
{
    // Points that are lit by normals of their own. Shaders' PointDrawing.hlsl is its twin.
    internal struct PointNormals
    {
        public int LitLevel; // Of PointLighting.MaxLitLevel; 0 where there are no normals.
        public PointLighting Light;

        // From the axes of the normals to those of the light, and of the view: right, up, forward; and from these to the light's.
        public double3x3 ToLight;
        public double3x3 ToView;
        public double3x3 ViewToLight;

        PointColumn m_u;
        PointColumn m_v;

        public PointNormals(PointBatch batch, int litLevel, in PointLighting light) : this()
        {
            int u = batch.Schema.IndexOf(StoreLayout.NormalColumns[0]);
            if (u < 0 || litLevel == 0)
                return;
            (LitLevel, Light) = (litLevel, light);
            (m_u, m_v) = (batch.Column(u), batch.Column(batch.Schema.IndexOf(StoreLayout.NormalColumns[1])));
        }

        // Colours become lit ones; normals are turned to the viewer, since points have no back.
        public readonly unsafe void LightColors(byte* bytes, int first, in PointProjection projection, in PointSpan span)
        {
            byte* u = m_u.At(bytes, first), v = m_v.At(bytes, first);
            for (int i = 0; i < span.Count; i++)
            {
                ushort code = (ushort)(u[i] | v[i] << 8);
                float3 normal = 0;
                var point = projection.X * span.X[i] + projection.Y * span.Y[i] + projection.Z * span.Z[i] + projection.W;
                if (code != OctahedralNormal.None)
                {
                    var stored = OctahedralNormal.Decode(code);
                    normal = (float3)math.normalize(math.mul(ToLight, stored));
                    var view = math.mul(ToView, stored);
                    double away = projection.IsOrthographic ? view.z : math.dot(view, point);
                    normal = away > 0 ? -normal : normal;
                }
                uint color = span.Colors[i];
                var lit = Light.Lit(new float3(color & 255, color >> 8 & 255, color >> 16 & 255) / 255, LitLevel, normal,
                    (float3)math.mul(ViewToLight, point), 1);
                lit = lit * 255 + 0.5f;
                span.Colors[i] = (uint)lit.x | (uint)lit.y << 8 | (uint)lit.z << 16 | color & 0xFF000000u;
            }
        }
    }
}
