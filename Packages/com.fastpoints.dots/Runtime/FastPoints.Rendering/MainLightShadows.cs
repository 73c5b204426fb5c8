using System;
using FastPoints.Drawing;
using FastPoints.Streaming;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering
{
    // The main light's depth map for one camera: what the light sees of the stream's last frame, as points of one pixel.
    sealed class MainLightShadows : IDisposable
    {
        readonly SizeTree m_noSizes = new SizeTree();
        readonly ListBuffer m_lists = new ListBuffer();
        readonly DrawList m_list;
        readonly ComputeRaster m_raster;
        StreamContext m_stream;
        StreamView m_view;
        StreamView? m_rightEye;
        ShadowMapProjection m_frame;
        bool m_isFit;

        public MainLightShadows(ComputeShader raster)
        {
            m_list = new DrawList(m_noSizes);
            m_raster = new ComputeRaster(raster, true);
        }

        // What the last picture's light needs to have loaded.
        public StreamView? View => m_isFit && m_frame.TexelWorld > 0 ? m_frame.ViewFor(m_view) : (StreamView?)null;

        public void Begin(StreamContext stream, in StreamView view, StreamView? rightEye)
        {
            (m_stream, m_view, m_rightEye) = (stream, view, rightEye);
            m_isFit = false;
        }

        // False where no cloud is in view.
        public bool Fit(float3 toLight)
        {
            if (m_isFit)
                return m_frame.TexelWorld > 0;
            m_frame = new ShadowMapProjection(toLight, 1);
            m_frame.Add(m_stream, m_view);
            if (m_rightEye != null)
                m_frame.Add(m_stream, m_rightEye.Value);
            m_frame.Fit();
            m_isFit = true;
            return m_frame.TexelWorld > 0;
        }

        public void Record(CommandBuffer commands, DrawList camera, GraphicsNodePool pool)
        {
            m_list.UseLooks(camera);
            m_list.Build(m_stream, m_frame.ViewFor(m_view));
            m_lists.Write(commands, m_list);
            float perUnit = (float)(2 / m_frame.EdgeWorld);
            var view = new RenderView
            {
                // However near or far: the map keeps what is nearest to the light.
                ViewProjection = ShaderValues.RowsOf(ShaderValues.VectorOf((float3)m_frame.Right * perUnit),
                    ShaderValues.VectorOf((float3)m_frame.Up * perUnit), new Vector4(0, 0, 0, 0.5f), new Vector4(0, 0, 0, 1)),
                WidthPx = ShadowMapProjection.EdgePx,
                HeightPx = ShadowMapProjection.EdgePx,
                Forward = ShaderValues.VectorOf((float3)m_frame.UnitForward),
                IsOrthographic = true,
            };
            m_raster.Record(commands, view, m_list, m_lists, pool, null);
        }

        // eyeOffset: from the eye that draws were listed for.
        public void Set(MaterialPropertyBlock properties, Vector3 eyeOffset)
        {
            var shadow = m_frame.From(m_view.EyeWorld + new double3(eyeOffset.x, eyeOffset.y, eyeOffset.z));
            properties.SetMatrix(ShaderNames.Shadow, ShaderValues.RowsOf(ShaderValues.VectorOf(shadow.Column, shadow.Eye.x),
                ShaderValues.VectorOf(shadow.Row, shadow.Eye.y), ShaderValues.VectorOf(shadow.Forward, shadow.Eye.z),
                new Vector4(shadow.TexelWorld, 0, 0, 0)));
            properties.SetBuffer(ShaderNames.ShadowPixels, m_raster.Pixels);
        }

        public void Dispose()
        {
            m_list.Dispose();
            m_lists.Dispose();
            m_raster.Dispose();
            m_noSizes.Dispose();
        }
    }
}
