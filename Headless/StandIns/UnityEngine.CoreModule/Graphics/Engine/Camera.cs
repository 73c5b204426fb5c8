using System.Collections.Generic;
using UnityEngine.Rendering;

namespace UnityEngine
{
    /// <summary>A host sets its matrices and its size; nothing is drawn by itself.</summary>
    public sealed class Camera : Behaviour
    {
        public delegate void CameraCallback(Camera cam);

        public static CameraCallback onPreCull;

        readonly List<(CameraEvent Event, CommandBuffer Commands)> m_commands = new List<(CameraEvent, CommandBuffer)>();

        public CameraType cameraType { get; set; } = CameraType.Game;

        public Matrix4x4 worldToCameraMatrix { get; set; } = Matrix4x4.identity;

        public Matrix4x4 projectionMatrix { get; set; } = Matrix4x4.identity;

        public RenderTexture targetTexture { get; set; }

        public int pixelWidth => targetTexture == null ? 0 : targetTexture.width;

        public int pixelHeight => targetTexture == null ? 0 : targetTexture.height;

        public void AddCommandBuffer(CameraEvent evt, CommandBuffer buffer) => m_commands.Add((evt, buffer));

        public void RemoveCommandBuffer(CameraEvent evt, CommandBuffer buffer) => m_commands.Remove((evt, buffer));

        /// <summary>Its target cleared, then the command buffers: what the Built-in pipeline makes of a camera in a scene without
        /// meshes.</summary>
        public void Render()
        {
            onPreCull?.Invoke(this);
            using (var target = new CommandBuffer())
            {
                target.SetRenderTarget(targetTexture);
                target.ClearRenderTarget(true, true, backgroundColor);
                Graphics.ExecuteCommandBuffer(target);
                target.Clear();
                target.SetRenderTarget(targetTexture);
                foreach (var (_, commands) in m_commands)
                    Graphics.Execute(target, commands, targetTexture);
            }
        }

        public Color backgroundColor { get; set; }
    }
}
