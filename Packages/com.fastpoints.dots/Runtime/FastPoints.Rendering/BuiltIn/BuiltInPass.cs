using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
#if FASTPOINTS_VR || FASTPOINTS_XR && UNITY_6000_5_OR_NEWER
using UnityEngine.XR;
#endif

namespace FastPoints.Rendering.BuiltIn
{
    // Draws the clouds in the Built-in pipeline: command buffers in each camera, before and after opaque meshes, recorded again
    // before each picture. The second draws into the camera's current target: the screen, a part of it or a texture.
    internal static class BuiltInPass
    {
        const CameraEvent BeforeOpaque = CameraEvent.BeforeForwardOpaque, AfterOpaque = CameraEvent.AfterForwardOpaque;
        const string Name = "FastPoints";

        static readonly List<Camera> s_cameras = new List<Camera>();
        static readonly List<(CommandBuffer BeforeOpaque, CommandBuffer AfterOpaque)> s_commands =
            new List<(CommandBuffer BeforeOpaque, CommandBuffer AfterOpaque)>();

        // Works with domain reload off, too: adding twice is harmless.
        [BeginsPass]
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        public static void Begin()
        {
            Camera.onPreCull -= Draw;
            Camera.onPreCull += Draw;
            Camera.onPreRender -= DrawRightEye;
            Camera.onPreRender += DrawRightEye;
        }

        public static void End()
        {
            Camera.onPreCull -= Draw;
            Camera.onPreRender -= DrawRightEye;
            for (int i = 0; i < s_cameras.Count; i++)
            {
                if (s_cameras[i] != null)
                {
                    s_cameras[i].RemoveCommandBuffer(BeforeOpaque, s_commands[i].BeforeOpaque);
                    s_cameras[i].RemoveCommandBuffer(AfterOpaque, s_commands[i].AfterOpaque);
                }
                Dispose(i);
            }
            s_cameras.Clear();
            s_commands.Clear();
        }

        // With multi-pass rendering both eyes are culled once, with the left one: the right one's commands would be the left's.
        static void DrawRightEye(Camera camera)
        {
            if (camera.stereoEnabled && camera.stereoActiveEye == Camera.MonoOrStereoscopicEye.Right && !IsSinglePass)
                Draw(camera);
        }

        static void Draw(Camera camera)
        {
            // Scriptable pipelines have their own passes.
            if (GraphicsSettings.currentRenderPipeline != null)
                return;
            bool isDrawn = PointScene.ShowsClouds(camera);
            // A camera that no longer draws clouds would repeat its last commands.
            if (!isDrawn && !s_cameras.Contains(camera))
                return;
            var (beforeOpaque, afterOpaque) = CommandsFor(camera);
            beforeOpaque.Clear();
            afterOpaque.Clear();
            var scene = PointScene.Current;
            if (scene == null || !isDrawn)
                return;
            scene.AddView(camera);
            RenderTargetIdentifier current = BuiltinRenderTextureType.CameraTarget;
            var target = CameraTarget.Of(camera, current, current, camera.stereoEnabled && IsSinglePass);
            target.MayBeScreen = true;
            if (scene.IsLit)
                target.Light = SceneLights.OfSun();
            scene.Record(beforeOpaque, afterOpaque, camera, target);
        }

        // A headset's eyes are drawn at once, into the slices of one texture. Unity 6.5 has this in another module.
        static bool IsSinglePass =>
#if FASTPOINTS_VR || FASTPOINTS_XR && UNITY_6000_5_OR_NEWER
            XRSettings.eyeTextureDesc.dimension == TextureDimension.Tex2DArray;
#else
            false;
#endif

        static (CommandBuffer BeforeOpaque, CommandBuffer AfterOpaque) CommandsFor(Camera camera)
        {
            for (int i = s_cameras.Count - 1; i >= 0; i--)
            {
                if (ReferenceEquals(s_cameras[i], camera))
                    return s_commands[i];
                if (s_cameras[i] != null)
                    continue;
                Dispose(i);
                s_commands.RemoveAt(i);
                s_cameras.RemoveAt(i);
            }
            var commands = (AddTo(camera, BeforeOpaque), AddTo(camera, AfterOpaque));
            s_cameras.Add(camera);
            s_commands.Add(commands);
            return commands;
        }

        static CommandBuffer AddTo(Camera camera, CameraEvent cameraEvent)
        {
            // A camera that outlives a reload of scripts, as a scene view's, still has the buffer from before.
            foreach (var old in camera.GetCommandBuffers(cameraEvent))
                if (old.name == Name)
                    camera.RemoveCommandBuffer(cameraEvent, old);
            var commands = new CommandBuffer { name = Name };
            camera.AddCommandBuffer(cameraEvent, commands);
            return commands;
        }

        static void Dispose(int camera)
        {
            s_commands[camera].BeforeOpaque.Dispose();
            s_commands[camera].AfterOpaque.Dispose();
        }
    }
}
