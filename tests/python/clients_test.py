# SPDX-License-Identifier: Apache-2.0
"""A client in Python drives a haptic server, by the real clock."""
import time

from support import Case, hapticell, main


class Clients(Case):
    def test_a_wall_is_felt(self):
        with hapticell.HapticServer() as server, hapticell.HapticClient(port=server.port) as client:
            self.assertTrue(client.device.simulated)
            self.assertGreater(client.device.peak_force, 1.0)
            client.enable_forces()
            felt = None
            for step in range(200):
                client.hold([0 if step < 100 else 0.015, 0, 0, 1, 0, 0, 0])
                client.send([0.010], [[-1, 0, 0, 0, 0, 0]], zone_radius=0.1)
                felt = client.state()
                time.sleep(0.01)
            self.assertLess(felt.force[0], -0.3)
            self.assertLess(felt.proxy[0], 0.0101)
            self.assertTrue(felt.forces_on)

    def test_no_server_is_an_error(self):
        error = self.assertError(lambda: hapticell.HapticClient(port=1, timeout=0.3), expected="a haptic server")
        self.assertIn("127.0.0.1:1", error.file)
        self.assertError(lambda: hapticell.HapticClient(port=0), place="port")

    def test_a_closed_client_says_so(self):
        with hapticell.HapticServer() as server:
            client = hapticell.HapticClient(port=server.port)
            self.assertError(lambda: client.send([0.0], [[1, 2]]), place="constraints")
            client.close()
            self.assertError(client.state, found="closed")

    def test_a_force_loop_in_python_is_refused(self):
        self.assertError(lambda: hapticell.ForceLoop(), expected="hapticell-haptic-server")


main()
