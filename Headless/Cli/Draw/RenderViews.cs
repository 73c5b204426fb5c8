using UnityEngine;

namespace FastPoints.Cli.Draw;

/// <summary>Makes views of a picture's camera, where the engine has no camera. Depth is reversed: 1 near, 0 far.</summary>
internal static class RenderViews
{
    public const double NearGeo = 1e-6;

    public static RenderView Of(in Camera camera, int widthPx, int heightPx, double depthGeo)
    {
        double aspect = (double)widthPx / heightPx;
        Vector4 x, y, z, w;
        if (camera.IsOrthographic)
        {
            double half = camera.HeightGeo / 2;
            x = Row(camera.Right, 1 / (half * aspect), 0);
            y = Row(camera.Up, 1 / half, 0);
            z = Row(camera.Forward, -0.5 / depthGeo, 0.5);
            w = new Vector4(0, 0, 0, 1);
        }
        else
        {
            double scale = 1 / Math.Tan(camera.FovRadians / 2);
            x = Row(camera.Right, scale / aspect, 0);
            y = Row(camera.Up, scale, 0);
            z = new Vector4(0, 0, 0, (float)NearGeo);
            w = Row(camera.Forward, 1, 0);
        }
        var clip = new Matrix4x4();
        clip.SetRow(0, x);
        clip.SetRow(1, y);
        clip.SetRow(2, z);
        clip.SetRow(3, w);
        return new RenderView
        {
            ViewProjection = clip,
            WidthPx = widthPx,
            HeightPx = heightPx,
            Forward = new Vector3((float)camera.Forward.x, (float)camera.Forward.y, (float)camera.Forward.z),
            ScalePx = (float)camera.ToStreamView(widthPx, heightPx).ScalePx,
            IsOrthographic = camera.IsOrthographic,
        };
    }

    static Vector4 Row(Unity.Mathematics.double3 axis, double scale, double constant) =>
        new Vector4((float)(axis.x * scale), (float)(axis.y * scale), (float)(axis.z * scale), (float)constant);
}
