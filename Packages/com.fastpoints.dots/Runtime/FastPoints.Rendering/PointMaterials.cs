using System;
using System.Collections.Generic;
using FastPoints.Store;
using UnityEngine;

namespace FastPoints.Rendering
{
    /// <summary>A material for each variant in use: Unity reads keywords when it executes commands, not when they are recorded,
    /// so one material could not draw two looks in a frame.</summary>
    public sealed class PointMaterials : IDisposable
    {
        static readonly string[] s_composed = { null, ShaderNames.FromPixelsKeyword, ShaderNames.BlendedKeyword };
        static readonly string[] s_lights = { null, ShaderNames.LitKeyword, ShaderNames.ShadowedKeyword };
        static readonly int[] s_corners = { 0, 1, 2, 2, 1, 3 };

        readonly Shader m_points;
        readonly Shader m_compose;
        readonly Material[] m_ofVariant = new Material[PointVariant.Count];
        readonly Material[] m_composeOf = new Material[s_lights.Length * s_composed.Length];
        GraphicsBuffer m_squareIndices;

        /// <param name="progressive">ProgressiveRaster.compute: without it, all points are drawn in every frame.</param>
        public PointMaterials(Shader points, Shader compose, ComputeShader raster = null, ComputeShader progressive = null) =>
            (m_points, m_compose, Raster, Progressive) = (points, compose, raster, progressive);

        internal const int IndicesOfSquare = 6;

        internal ComputeShader Raster { get; }

        internal ComputeShader Progressive { get; }

        // Two triangles of four vertices for each point of a block, so that the GPU computes shared vertices once.
        internal GraphicsBuffer SquareIndices
        {
            get
            {
                if (m_squareIndices != null)
                    return m_squareIndices;
                var indices = new ushort[PlaneShape.MaxPointsPerBlock * IndicesOfSquare];
                for (int i = 0; i < indices.Length; i++)
                    indices[i] = (ushort)(i / IndicesOfSquare * 4 + s_corners[i % IndicesOfSquare]);
                m_squareIndices = new GraphicsBuffer(GraphicsBuffer.Target.Index, indices.Length, sizeof(ushort));
                m_squareIndices.SetData(indices);
                return m_squareIndices;
            }
        }

        internal Material For(in PointStyle style, bool isClipped, bool isFiltered, bool isStereo)
        {
            var variant = new PointVariant(style, isClipped, isFiltered, isStereo);
            if (m_ofVariant[variant.Number] != null)
                return m_ofVariant[variant.Number];
            var material = Make(m_points);
            foreach (string keyword in variant.Keywords)
                material.EnableKeyword(keyword);
            return m_ofVariant[variant.Number] = material;
        }

        internal Material ForCompose(ComposedFrom from, in PointStyle style)
        {
            int light = style.IsShadowed ? 2 : style.IsLit ? 1 : 0;
            ref var material = ref m_composeOf[s_lights.Length * (int)from + light];
            if (material != null)
                return material;
            material = Make(m_compose);
            if (s_composed[(int)from] != null)
                material.EnableKeyword(s_composed[(int)from]);
            if (light > 0)
                material.EnableKeyword(s_lights[light]);
            return material;
        }

        public void Dispose()
        {
            for (int variant = 0; variant < m_ofVariant.Length; variant++)
                Destroy(ref m_ofVariant[variant]);
            for (int compose = 0; compose < m_composeOf.Length; compose++)
                Destroy(ref m_composeOf[compose]);
            m_squareIndices?.Dispose();
            m_squareIndices = null;
        }

        static Material Make(Shader shader) => new Material(shader) { hideFlags = HideFlags.HideAndDontSave };

        static void Destroy(ref Material material)
        {
            if (material == null)
                return;
            // A paused editor has no next frame to destroy them.
            if (Application.isEditor)
                UnityEngine.Object.DestroyImmediate(material);
            else
                UnityEngine.Object.Destroy(material);
            material = null;
        }
    }

    // What Compose.shader reads: textures, what RasterPoints.hlsl made, or textures and sums of splats.
    internal enum ComposedFrom { Layer, Pixels, Sums }

    // A variant of Points.shader: the keywords that a draw needs.
    internal readonly struct PointVariant
    {
        internal const int Count = Shapes << 5; // Range of Number; no draw needs all of them.

        const int Shapes = 1 + (int)PointShape.Paraboloid;

        // Pixels have none.
        static readonly string[] s_shapes =
        {
            null, ShaderNames.SquaresKeyword, ShaderNames.DiscsKeyword, ShaderNames.ParaboloidsKeyword,
        };

        static readonly string[] s_options =
        {
            ShaderNames.AdaptiveKeyword, ShaderNames.LayeredKeyword, ShaderNames.ClippedKeyword, ShaderNames.FilteredKeyword,
            ShaderNames.StereoKeyword,
        };

        readonly int m_shape;
        readonly int m_options; // Each bit is an index in s_options.

        // Splats are drawn as discs, into a layer; styles with a layer draw both eyes one after the other. Progressive pictures'
        // pass has shapes and adaptive sizes alone.
        public PointVariant(in PointStyle style, bool isClipped, bool isFiltered, bool isStereo)
        {
            m_shape = (int)(style.IsBlended ? PointShape.Disc : style.Shape);
            m_options = style.IsAdaptive ? 1 : 0;
            if (!style.IsProgressive)
                m_options |= (style.IsLayered ? 2 : 0) | (isClipped ? 4 : 0) | (isFiltered ? 8 : 0) |
                    (isStereo && !style.IsLayered ? 16 : 0);
        }

        internal int Number => m_shape + Shapes * m_options;

        public IEnumerable<string> Keywords
        {
            get
            {
                if (s_shapes[m_shape] != null)
                    yield return s_shapes[m_shape];
                for (int option = 0; option < s_options.Length; option++)
                    if ((m_options >> option & 1) != 0)
                        yield return s_options[option];
            }
        }
    }
}
