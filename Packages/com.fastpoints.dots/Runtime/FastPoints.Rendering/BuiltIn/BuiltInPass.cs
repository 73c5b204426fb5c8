using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace FastPoints.Rendering.BuiltIn
{
    /// <summary>Draws the clouds in the Built-in pipeline: a command buffer in each camera, after opaque meshes, recorded again
    /// before each picture. It needs no setup.</summary>
    internal static class BuiltInPass
    {
        const CameraEvent Place = CameraEvent.AfterForwardOpaque;
        const string Name = "FastPoints";

        static readonly List<Camera> s_cameras = new List<Camera>();
        static readonly List<CommandBuffer> s_commands = new List<CommandBuffer>();

        /// <summary>Works with domain reload off, too: adding twice adds once.</summary>
        [BeginsPass]
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        public static void Begin()
        {
            Camera.onPreCull -= Draw;
            Camera.onPreCull += Draw;
        }

        /// <summary>Removes the command buffers from all cameras.</summary>
        public static void End()
        {
            Camera.onPreCull -= Draw;
            for (int i = 0; i < s_cameras.Count; i++)
            {
                if (s_cameras[i] != null)
                    s_cameras[i].RemoveCommandBuffer(Place, s_commands[i]);
                s_commands[i].Dispose();
            }
            s_cameras.Clear();
            s_commands.Clear();
        }

        static void Draw(Camera camera)
        {
            // Scriptable pipelines have passes of their own.
            if (GraphicsSettings.currentRenderPipeline != null)
                return;
            bool isDrawn = PointScene.IsDrawn(camera);
            // A camera that draws clouds no more would go on with its last commands.
            if (!isDrawn && !s_cameras.Contains(camera))
                return;
            var commands = CommandsFor(camera);
            commands.Clear();
            var scene = PointScene.Current;
            if (scene == null || !isDrawn)
                return;
            scene.Announce(camera);
            scene.Record(commands, camera,
                CameraTarget.Of(camera, BuiltinRenderTextureType.CameraTarget, BuiltinRenderTextureType.CameraTarget));
        }

        static CommandBuffer CommandsFor(Camera camera)
        {
            for (int i = s_cameras.Count - 1; i >= 0; i--)
            {
                if (ReferenceEquals(s_cameras[i], camera))
                    return s_commands[i];
                if (s_cameras[i] != null)
                    continue;
                s_commands[i].Dispose();
                s_commands.RemoveAt(i);
                s_cameras.RemoveAt(i);
            }
            // A camera that outlives a reload of scripts, as a scene view's, still has the buffer from before.
            foreach (var old in camera.GetCommandBuffers(Place))
                if (old.name == Name)
                    camera.RemoveCommandBuffer(Place, old);
            var commands = new CommandBuffer { name = Name };
            camera.AddCommandBuffer(Place, commands);
            s_cameras.Add(camera);
            s_commands.Add(commands);
            return commands;
        }
    }
}
